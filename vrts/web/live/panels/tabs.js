// Tabs of the panels: arrow keys, counts of what is new, and the monitor's place on narrow screens.

import { byId, make } from "../dom.js";

const NARROW = window.matchMedia("(max-width: 960px)");
const PHONE = window.matchMedia("(max-width: 700px) and (orientation: portrait)");

/** @param {import("../pages/room.js").App} app */
export function mountTabs({ store }) {
  const bar = byId("tabs");
  const panels = /** @type {HTMLElement[]} */ (Array.from(byId("panels").children));
  const tabs = panels.map((panel) => {
    const tab = make("button", {
      type: "button", role: "tab", id: panel.id.replace("panel", "tab"), "aria-controls": panel.id,
      text: panel.dataset.title ?? "", click: () => show(panel.id),
    });
    panel.setAttribute("role", "tabpanel");
    panel.setAttribute("aria-labelledby", tab.id);
    return tab;
  });
  bar.replaceChildren(...tabs);

  /** @param {string} id of a panel */
  function show(id) {
    panels.forEach((panel, index) => {
      const chosen = panel.id === id;
      panel.hidden = !chosen;
      tabs[index].setAttribute("aria-selected", String(chosen));
      tabs[index].tabIndex = chosen ? 0 : -1;
      if (chosen) {
        delete tabs[index].dataset.count;
        tabs[index].scrollIntoView({ block: "nearest", inline: "nearest" });
      }
    });
    sessionStorage.setItem("vrts panel", id);
    document.dispatchEvent(new CustomEvent("panel", { detail: id }));
  }

  bar.addEventListener("keydown", (/** @type {KeyboardEvent} */ event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    const shown = tabs.filter((tab) => !tab.hidden);
    const next = shown[(shown.indexOf(/** @type {any} */ (event.target)) + step + shown.length) % shown.length];
    event.preventDefault();
    next.focus();
    next.click();
  });

  /** The monitor stands under the view where there is room. */
  function arrange() {
    (NARROW.matches ? byId("panel-monitor") : byId("terminal-place")).append(byId("terminal"));
    byId("tab-monitor").hidden = !NARROW.matches;
    const chosen = tabs.find((tab) => tab.getAttribute("aria-selected") === "true");
    if (!chosen || chosen.hidden) show("panel-pendant");
  }
  store.on(["supervisor", "alone", "robots"], ({ supervisor, alone, robots }) => {
    for (const [name, wanted] of /** @type {const} */ ([["lead", supervisor && !alone], ["people", !alone], ["chat", !alone], ["own", robots]])) {
      byId(`tab-${name}`).hidden = !wanted;
      byId(`panel-${name}`).hidden ||= !wanted;
    }
  });
  const before = sessionStorage.getItem("vrts panel");
  const there = panels.some((panel, index) => panel.id === before && !tabs[index].hidden);
  show(there && before ? before : PHONE.matches ? "panel-monitor" : "panel-pendant"); // phones watch, mostly
  NARROW.addEventListener("change", arrange);
  arrange();
}

/** Show that a panel has something new. @param {string} name such as "chat" */
export function count(name) {
  if (!byId(`panel-${name}`).hidden) return;
  const tab = byId(`tab-${name}`);
  tab.dataset.count = String(Math.min(Number(tab.dataset.count ?? 0) + 1, 99));
}
