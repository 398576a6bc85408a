// What is still missing in a form, said at its place.

/**
 * Say it; the next attempt is not held up by it (such forms have `novalidate`).
 * @param {HTMLInputElement | HTMLTextAreaElement | HTMLSelectElement} input @param {string} words
 */
export function missing(input, words) {
  input.setCustomValidity(words);
  input.reportValidity();
  input.addEventListener("input", () => input.setCustomValidity(""), { once: true });
}
