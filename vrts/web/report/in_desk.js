// The report in a frame of the grading desk: shows what the desk asks for, and says what it shows.

/**
 * Obey the page around, if it asked for that in the address, and return who tells it what is shown.
 * In a page that is opened alone nothing is heard and nothing said.
 * @param {{show: (time_s: number) => void, showLine: (line: number) => void, comment: (told: unknown) => void, end: number}} acts
 * @returns {(time_s: number, line: number) => void}
 */
export function obeyDesk(acts) {
  const around = window.parent;
  const asked = new URLSearchParams(location.hash.slice(1)).get("framed");
  if (around === window || asked === null) return () => {};
  document.documentElement.classList.add("framed", ...(asked === "picture" ? ["picture"] : [])); // without what steers
  window.addEventListener("message", (event) => {
    if (event.source === around && event.data?.vrts === "comments") acts.comment(event.data.comments);
    if (event.source !== around || event.data?.vrts !== "show") return;
    const { time_s, line } = event.data;
    if (Number.isFinite(time_s)) acts.show(Math.min(Math.max(time_s, 0), acts.end));
    else if (Number.isInteger(line)) acts.showLine(line);
  });
  // a frame has no right to know who is around it: what is told are times and lines
  const say = (/** @type {Record<string, unknown>} */ words) => around.postMessage(words, "*");
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && !event.defaultPrevented) say({ vrts: "leave" });
  });
  document.getElementById("source")?.addEventListener("click", (event) => {
    const line = /** @type {HTMLElement} */ (event.target).closest("li")?.id.slice(1);
    if (line) say({ vrts: "line", line: Number(line) });
  });
  return (time_s, line) => say({ vrts: "shown", time_s, line, end_s: acts.end });
}
