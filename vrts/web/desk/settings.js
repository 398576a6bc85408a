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
    make("div", { class: "setting" }, make("span", { text: "Every program" }), button("Mark all again …", async () => {
      box.hidePopover();
      const title = `Mark ${counted(desk.rows.size, "program")} again?`;
      if (await ask(title, [make("p", { text: "This takes a while. Decisions by hand stay, and are told where they were made about another program." })], "Mark all again")) await desk.markAgain("all");
    })));
}
