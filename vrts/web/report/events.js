// The list of what happened, to click on; contacts stand between the events.

/** One row for each event, in time order. */
export class EventList {
  /**
   * @param {HTMLElement} list
   * @param {{run: {events: Row[]}, contacts: Contact[]}} data
   * @param {(t: number) => void} jump
   */
  constructor(list, data, jump) {
    this.list = list;
    const contacts = data.contacts.map((c) => ({ t: c.start, kind: "contact", text: c.text, line: c.line }));
    /** @type {Row[]} */
    this.rows = [...data.run.events, ...contacts].sort((a, b) => a.t - b.t);
    this.buttons = this.rows.map((row) => button(row, () => jump(row.t)));
    list.replaceChildren(...this.buttons.map((entry) => {
      const item = document.createElement("li");
      item.append(entry);
      return item;
    }));
    this.current = -1;
  }

  /** @param {number} t [s]; marks the last event that is not later */
  show(t) {
    let index = -1;
    while (index + 1 < this.rows.length && this.rows[index + 1].t <= t + 5e-4) index++;
    if (index === this.current) return;
    this.buttons[this.current]?.classList.remove("now");
    this.buttons[this.current]?.removeAttribute("aria-current");
    this.current = index;
    const entry = this.buttons[index];
    if (!entry) return;
    entry.classList.add("now");
    entry.setAttribute("aria-current", "true");
    const above = entry.offsetTop - this.list.scrollTop;
    if (above < 0 || above > this.list.clientHeight - 30) this.list.scrollTop = entry.offsetTop - this.list.clientHeight / 2;
  }

  /** Return the time of the next event after a time, or the last. */
  after(/** @type {number} */ t) {
    return this.rows.find((row) => row.t > t + 1e-3)?.t ?? t;
  }

  /** Return the time of the event before a time, or the start. */
  before(/** @type {number} */ t) {
    return this.rows.findLast((row) => row.t < t - 1e-3)?.t ?? 0;
  }
}

/** @typedef {{t: number, kind: string, text: string, line: number, process?: boolean}} Row */
/** @typedef {{start: number, text: string, line: number}} Contact */

/** Return the line of a row; PC stands for the process control program. @param {Row} row */
function where(row) {
  return row.line ? `${row.process ? "PC " : ""}line ${row.line}` : "";
}

/** @param {Row} row @param {() => void} click */
function button(row, click) {
  const element = document.createElement("button");
  element.type = "button";
  element.className = row.kind;
  for (const [name, text] of [["t", `${row.t.toFixed(2)} s`], ["words", row.text], ["line", where(row)]]) {
    const part = document.createElement("span");
    part.className = name;
    part.textContent = text;
    element.append(part);
  }
  element.addEventListener("click", click);
  return element;
}
