// Tabs of a pane: arrows go from one to the next, Tab goes into what is shown.

import { make } from "../../live/dom.js";

/**
 * Return tabs and their panels. Each panel is scrolled by itself.
 * @param {string} name of them all, for ids and screen readers @param {[string, string, HTMLElement][]} parts id, title, panel
 */
export function tabs(name, parts) {
  const heads = parts.map(([id, title, panel]) => {
    panel.id = `panel-${id}`;
    panel.setAttribute("role", "tabpanel");
    panel.setAttribute("aria-labelledby", `tab-${id}`);
    panel.classList.add("panel");
    panel.tabIndex = 0;
    return make("button", { type: "button", role: "tab", id: `tab-${id}`, "aria-controls": panel.id, text: title, click: () => choose(id) });
  });
  const bar = make("div", { class: "tabs", role: "tablist", "aria-label": name }, ...heads);
  /** @param {string} id */
  function choose(id) {
    parts.forEach(([other, , panel], k) => {
      const now = other === id;
      heads[k].setAttribute("aria-selected", String(now));
      heads[k].tabIndex = now ? 0 : -1;
      panel.hidden = !now;
    });
  }
  bar.addEventListener("keydown", (event) => {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    const at = heads.findIndex((head) => head === event.target);
    if (!by || at < 0) return;
    event.preventDefault();
    event.stopPropagation(); // the replay stays where it is
    const next = (at + by + parts.length) % parts.length;
    choose(parts[next][0]);
    heads[next].focus();
  });
  choose(parts[0][0]);
  return { bar, choose, panels: parts.map(([, , panel]) => panel) };
}
