// The page about every future: what is chosen in the tree of decisions, and which replay is shown.

(() => {
  const byId = (/** @type {string} */ id) => document.getElementById(id);
  const held = byId("nodes");
  const chosen = byId("chosen");
  if (!held) return;
  /** @typedef {{title: string, many: number, last: number, ends: string, story: [number, string, string][], scenario: string, replay: string | null, wrong: number[]}} Told */
  /** @type {{nodes: Told[]}} */
  const { nodes } = JSON.parse(held.textContent ?? "{}");

  /** Make an element with a text. @param {string} name @param {string} text @param {string} [kind] */
  function made(name, text, kind) {
    const element = document.createElement(name);
    element.textContent = text;
    if (kind) element.className = kind;
    return element;
  }

  /** A way to a replay. @param {string} key @param {string} text */
  function watch(key, text) {
    const link = /** @type {HTMLAnchorElement} */ (made("a", text, "watch"));
    link.href = `#future=${key}`;
    link.dataset.future = key;
    return link;
  }

  /** Show the story and the scenario of a node. */
  function show(/** @type {number} */ number) {
    const node = nodes[number];
    if (!chosen || !node) return;
    const list = document.createElement("ol");
    list.className = "story";
    for (const [time, where, what] of node.story) {
      const row = document.createElement("li");
      row.append(made("span", `${time.toFixed(3)} s`, "t"), made("span", what), made("span", where, "line"));
      list.append(row);
    }
    const more = node.many > 1 ? ` It stands for ${node.many} futures that are alike; the last begins at ${node.last.toFixed(3)} s.` : "";
    const details = document.createElement("details");
    details.append(made("summary", "The scenario"), made("pre", node.scenario, "scenario"));
    const links = node.wrong.filter((n) => byId(n === 1 ? "data" : `data-${n}`)).map((n) => watch(String(n), `Watch ${n}`));
    if (node.replay) links.push(watch(node.replay, "Watch it"));
    chosen.replaceChildren(made("h3", node.title), made("p", `${node.ends}.${more}`.replace(/^./, (c) => c.toUpperCase())), list, details, ...links);
    for (const other of document.querySelectorAll(".tree a.now")) other.classList.remove("now");
    byId(`node-${number + 1}`)?.classList.add("now");
  }

  document.addEventListener("click", (event) => {
    const target = /** @type {Element} */ (event.target);
    const node = target.closest("a[data-node]");
    if (node) {
      event.preventDefault();
      show(Number(/** @type {SVGElement} */ (node).dataset.node));
      return;
    }
    const link = /** @type {HTMLElement | null} */ (target.closest("a[data-future]"));
    if (link) { // the replay is made when the page opens
      event.preventDefault();
      location.hash = `future=${link.dataset.future}`;
      location.reload();
    }
  });

  const asked = new URLSearchParams(location.hash.slice(1)).get("future");
  const card = asked && /^\d+$/.test(asked) ? byId(`future-${asked}`) : null;
  const right = nodes.findIndex((node) => asked !== null && node.replay === asked);
  const shown = byId("shown");
  if (shown && (card || right >= 0)) {
    shown.textContent = card ? card.querySelector("h3")?.textContent ?? "" : nodes[right].title;
    byId("replay")?.scrollIntoView();
  }
  /** Bring a node of the tree into sight, and nothing else of the page. */
  function bring(/** @type {number} */ number) {
    const view = document.querySelector(".tree-view");
    const node = byId(`node-${number + 1}`)?.getBoundingClientRect();
    if (!view || !node) return;
    const frame = view.getBoundingClientRect();
    view.scrollTop += node.top - frame.top - frame.height / 2;
    view.scrollLeft += node.left - frame.left - frame.width / 3;
  }

  const first = right >= 0 ? right : nodes.findIndex((node) => node.wrong.includes(Number(asked ?? 1)));
  show(Math.max(first, 0));
  bring(Math.max(first, 0));
})();
