// All that one student has handed in.

import { byId, make, prose } from "../../live/dom.js";
import { counted, points, when } from "./words.js";

/** @param {number} id @param {import("./types.js").Board} board */
export async function showStudent(id, board) {
  const dialog = /** @type {HTMLDialogElement} */ (byId("student"));
  const student = board.students.find((one) => one.id === id);
  byId("student-title").textContent = student?.name ?? "";
  const work = byId("student-work");
  work.replaceChildren(make("p", { class: "soft", text: "Loading …" }));
  byId("student-close").onclick = () => dialog.close();
  dialog.showModal();
  try {
    const answer = await fetch(`/course/board/student/${id}`);
    const told = await answer.json();
    if (!answer.ok) throw new Error(told.text);
    work.replaceChildren(...parts(told, board.columns));
  } catch (problem) {
    work.replaceChildren(make("p", { role: "alert", text: `This cannot be shown: ${/** @type {Error} */ (problem).message}` }));
  }
}

/** @param {import("./types.js").Work} work @param {import("./types.js").Column[]} columns */
function parts({ attempts }, columns) {
  if (!attempts.length) return [make("p", { class: "soft", text: "Nothing is handed in." })];
  return columns.flatMap(({ id, title }) => {
    const own = attempts.filter(({ assignment }) => assignment === id).reverse();
    if (!own.length) return [];
    const head = make("tr", {}, ...["Attempt", "When", "Public mark", "Lost by"].map((text) => make("th", { scope: "col", text })));
    const rows = own.map((one) => make("tr", {},
      make("th", { scope: "row", text: String(one.number) }), make("td", { text: one.late ? `${when(one.at)}, ${one.late}` : when(one.at) }),
      make("td", { text: one.mark === null ? one.state : `${points(one.mark)} of ${points(one.total)}` }),
      make("td", {}, one.losses.length ? make("ul", {}, ...one.losses.map(([words, lost]) => make("li", {}, `${points(lost)}: `, ...prose(words)))) : one.mark === null ? "" : "nothing")));
    return [make("h3", { text: `${title}: ${counted(own.length, "attempt")}` }), make("table", {}, make("thead", {}, head), make("tbody", {}, ...rows))];
  });
}
