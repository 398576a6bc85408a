// What may be too wide for a narrow window can be scrolled by keys, too.
"use strict";
const LONG = 38; // characters of a line that still fit on a phone
document.addEventListener("DOMContentLoaded", () => {
  for (const code of document.querySelectorAll("pre")) {
    if (code.textContent.split("\n").some((line) => line.length > LONG)) code.tabIndex = 0;
  }
  document.querySelectorAll(".table-wrapper").forEach((table, index) => {
    table.tabIndex = 0;
    table.setAttribute("role", "region");
    table.setAttribute("aria-label", `Table ${index + 1}`);
  });
});
