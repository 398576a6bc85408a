// Sorts, searches and filters the table of submissions; rows are put in place once a change.

const byId = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
const table = /** @type {HTMLTableElement} */ (byId("submissions"));
const body = table.tBodies[0];
const heads = [...table.querySelectorAll("th")];
const search = /** @type {HTMLInputElement} */ (byId("search"));
const kind = /** @type {HTMLSelectElement} */ (byId("kind"));
const boxes = [...byId("filters").querySelectorAll("input[type=checkbox]")].map((box) => /** @type {HTMLInputElement} */ (box));
const buttons = [...document.querySelectorAll("button[data-kind]")].map((button) => /** @type {HTMLElement} */ (button));
const order = new Intl.Collator(undefined, { numeric: true, sensitivity: "base" });

/** What is known of every row, read from the page once. */
const rows = [...body.rows].map((element) => ({
  element,
  keys: [...element.cells].map((cell) => cell.dataset.sort ?? ""),
  found: `${element.dataset.found} ${element.textContent}`.toLowerCase(),
  kind: element.dataset.kind,
  flags: (element.dataset.flags ?? "").split(" "),
}));

heads.forEach((head, column) => head.addEventListener("click", () => sort(head, column)));
search.addEventListener("input", filter);
kind.addEventListener("change", filter);
for (const box of boxes) box.addEventListener("change", filter);
for (const button of buttons) {
  button.addEventListener("click", () => {
    kind.value = kind.value === button.dataset.kind ? "" : button.dataset.kind ?? "";
    filter();
    byId("all").scrollIntoView();
  });
}
document.addEventListener("keydown", (event) => {
  const typing = event.target instanceof HTMLElement && event.target.matches("input[type=search], select");
  if (event.key === "/" && !typing && !event.ctrlKey && !event.metaKey && !event.altKey) {
    event.preventDefault();
    search.focus();
  }
});
filter(); // a browser may have kept what was typed before

/** @param {Element} head @param {number} column */
function sort(head, column) {
  const down = head.getAttribute("aria-sort") === "ascending";
  for (const other of heads) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", down ? "descending" : "ascending");
  const numbers = head.classList.contains("number");
  const compare = numbers
    ? (/** @type {string} */ a, /** @type {string} */ b) => Number(a) - Number(b)
    : order.compare;
  rows.sort((a, b) => compare(a.keys[column], b.keys[column]) * (down ? -1 : 1));
  body.replaceChildren(...rows.map((row) => row.element));
}

/** Show the rows that have every word, the status, and every flag that is asked for. */
function filter() {
  const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
  const flags = boxes.filter((box) => box.checked).map((box) => box.value);
  let count = 0;
  for (const row of rows) {
    const fits = (!kind.value || row.kind === kind.value) &&
      flags.every((flag) => row.flags.includes(flag)) && words.every((word) => row.found.includes(word));
    row.element.hidden = !fits;
    count += Number(fits);
  }
  byId("count").textContent = `${count} of ${rows.length}`;
  byId("none").hidden = count > 0 || !rows.length;
  for (const button of buttons) button.setAttribute("aria-pressed", String(button.dataset.kind === kind.value));
}
