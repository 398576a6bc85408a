// Light or dark: as the system has it, or as somebody wants it here.

const KEPT = "vrts theme";
const MEDIA = /\(prefers-color-scheme:\s*(dark|light)\)/;
const system = window.matchMedia("(prefers-color-scheme: dark)");

/** @typedef {"system"|"light"|"dark"} Choice */

/** @returns {Choice} */
export function chosenTheme() {
  const kept = localStorage.getItem(KEPT);
  return kept === "light" || kept === "dark" ? kept : "system";
}

/** Choose, and remember it in this browser. @param {Choice} choice */
export function chooseTheme(choice) {
  localStorage.setItem(KEPT, choice);
  applyTheme(choice);
  document.dispatchEvent(new CustomEvent("theme"));
}

/** @returns {"dark"|"light"} what is shown */
export function theme() {
  const choice = chosenTheme();
  if (choice !== "system") return choice;
  return system.matches ? "dark" : "light";
}

/** Call back whenever another theme is shown. @param {() => void} tell */
export function onTheme(tell) {
  system.addEventListener("change", tell);
  document.addEventListener("theme", tell);
}

/**
 * Let the style sheets' own rules for dark hold always, never, or as the system says.
 * @param {Choice} choice
 */
export function applyTheme(choice) {
  document.documentElement.style.colorScheme = choice === "system" ? "" : choice;
  for (const sheet of document.styleSheets) {
    for (const rule of sheet.cssRules) {
      if (!(rule instanceof CSSMediaRule)) continue;
      const known = WRITTEN.get(rule) ?? rule.media.mediaText;
      const asked = MEDIA.exec(known)?.[1];
      if (!asked) continue;
      WRITTEN.set(rule, known);
      rule.media.mediaText = choice === "system" ? known : asked === choice ? "all" : "not all";
    }
  }
}

/** What the style sheets say, by rule. @type {WeakMap<CSSMediaRule, string>} */
const WRITTEN = new WeakMap();
