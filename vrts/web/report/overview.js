// Sorts the table of submissions by the column whose head is clicked.

const table = /** @type {HTMLTableElement} */ (document.getElementById("submissions"));
const heads = [...table.querySelectorAll("th")];

heads.forEach((head, column) => head.addEventListener("click", () => sort(head, column)));

/** @param {Element} head @param {number} column */
function sort(head, column) {
  const down = head.getAttribute("aria-sort") === "ascending";
  for (const other of heads) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", down ? "descending" : "ascending");
  const body = table.tBodies[0];
  const rows = [...body.rows].sort((a, b) => compare(key(a, column), key(b, column)) * (down ? -1 : 1));
  body.replaceChildren(...rows);
}

/** @param {HTMLTableRowElement} row @param {number} column */
function key(row, column) {
  return row.cells[column].dataset.sort ?? "";
}

/** @param {string} a @param {string} b */
function compare(a, b) {
  const difference = Number(a) - Number(b);
  return Number.isNaN(difference) ? a.localeCompare(b, undefined, { numeric: true }) : difference;
}
