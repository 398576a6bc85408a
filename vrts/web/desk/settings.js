// Settings of this browser: light or dark, single keys on or off.

import { button, byId, choice, make } from "../live/dom.js";
import { applyTheme, chooseTheme, chosenTheme } from "../live/themes.js";
import { ask } from "./ask.js";
import { keysOn, turnKeys } from "./keys.js";
import { counted } from "./words.js";

/** @param {import("./desk.js").Desk} desk */
export function settings(desk) {
  applyTheme(chosenTheme());
  const theme = choice([["system", "As the system"], ["light", "Light"], ["dark", "Dark"]], { id: "setting-theme" });
  theme.value = chosenTheme();
  theme.addEventListener("change", () => chooseTheme(/** @type {import("../live/themes.js").Choice} */ (theme.value)));
  const keys = make("input", { type: "checkbox", id: "setting-keys", checked: keysOn() });
  keys.addEventListener("change", () => turnKeys(keys.checked));
  const box = byId("settings");
  box.append(
    make("div", { class: "setting" }, make("label", { for: "setting-theme", text: "Colours" }), theme),
    make("div", { class: "setting" }, make("label", { for: "setting-keys", text: "Single-letter keys" }), keys),
    make("div", { class: "setting" }, make("span", { text: "Mark again" }),
      make("span", { class: "range" }, button("The list …", () => void again(false)), button("All …", () => void again(true)))));

  /** @param {boolean} all */
  async function again(all) {
    box.hidePopover();
    const students = all ? [...desk.rows.keys()] : desk.listed.map((row) => row.id);
    if (!students.length) return;
    const body = make("p", { text: "This takes a while. You can stop it. Decisions stay. If a student has another program now, decisions about the old one do not count: the desk shows which." });
    if (await ask(`Mark ${counted(students.length, "program")} again?`, [body], "Mark again")) await desk.markAgain(all ? "all" : students);
  }
}
