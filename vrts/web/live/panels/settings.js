// What each browser has its own way: colours, frames a second; and the way out.

import { logOut } from "../account.js";
import { byId, button, make, write } from "../dom.js";
import { chosenTheme, chooseTheme } from "../themes.js";

const KEPT = "vrts rate";
const SLOWEST = 1;
const FASTEST = 60; // frames a second
const USUAL = 50;
const PHONE_RATE = 15;
const PHONE = window.matchMedia("(max-width: 700px) and (orientation: portrait)");
const THEMES = /** @type {const} */ ([["system", "System"], ["light", "Light"], ["dark", "Dark"]]);

/** @returns {number} frames a second that are wanted: chosen here, else what suits the screen */
export function wantedRate() {
  const kept = Math.round(Number(localStorage.getItem(KEPT)));
  if (kept >= SLOWEST && kept <= FASTEST) return kept;
  return PHONE.matches ? PHONE_RATE : USUAL;
}

/** @param {import("../pages/room.js").App} app */
export function mountSettings({ store, connection, toasts }) {
  const themes = THEMES.map(([choice, text]) => button(text, () => choose(choice), { "data-theme": choice }));
  const rate = make("input", { type: "range", id: "rate-wanted", min: SLOWEST, max: FASTEST, step: 1, input: told, change: keep });
  const shown = make("output", { for: "rate-wanted", class: "number" });
  const out = button("Log out", leave, { id: "log-out" });
  byId("settings").replaceChildren(
    make("div", { class: "setting" }, make("span", { id: "theme-label", text: "Colours" }),
      make("div", { class: "segmented", role: "group", "aria-labelledby": "theme-label" }, ...themes)),
    make("div", { class: "setting" }, make("label", { for: "rate-wanted", text: "Frames a second" }), make("span", { class: "range" }, rate, shown)),
    make("div", { class: "setting", hidden: store.now.alone }, make("span", { class: "soft", text: "Needs a code or an account to come back" }), out),
  );
  PHONE.addEventListener("change", follow);
  choose(chosenTheme());
  follow();

  /** @param {import("../themes.js").Choice} choice */
  function choose(choice) {
    if (choice !== chosenTheme()) chooseTheme(choice);
    for (const one of themes) one.setAttribute("aria-pressed", String(one.dataset.theme === choice));
  }

  function told() {
    write(shown, rate.value);
  }

  function keep() {
    localStorage.setItem(KEPT, rate.value);
    follow();
  }

  function follow() {
    rate.value = String(wantedRate());
    told();
    if (connection.rate !== wantedRate()) connection.setRate(wantedRate());
  }

  async function leave() {
    try {
      await logOut();
      sessionStorage.clear(); // whoever comes next in this tab reads nothing of it
      location.assign("/");
    } catch (error) {
      toasts.warn(/** @type {Error} */ (error).message);
    }
  }
}
