// What is still missing in a form, or too much of it, said at its place.

export const WORDS = 2000; // characters of a comment or a reason that can be written
export const POINTS = "Points are a number with at most three decimals, such as −0.5.";

/**
 * Say it; the next attempt is not held up by it (such forms have `novalidate`).
 * @param {HTMLInputElement | HTMLTextAreaElement | HTMLSelectElement} input @param {string} words
 */
export function missing(input, words) {
  input.setCustomValidity(words);
  input.reportValidity();
  input.addEventListener("input", () => input.setCustomValidity(""), { once: true });
}

/**
 * Return whether a text is too long, and say so; all of it stays in its field.
 * @param {HTMLInputElement | HTMLTextAreaElement} input
 */
export function tooLong(input) {
  const beyond = input.value.trim().length - WORDS;
  if (beyond > 0) missing(input, `At most ${WORDS.toLocaleString("en")} characters can be written: these are ${beyond.toLocaleString("en")} more. Nothing was written, and nothing is cut off.`);
  return beyond > 0;
}
