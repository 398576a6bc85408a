// The page of two programs: one time bar for both replays. Not a module: it needs none.

const bar = /** @type {HTMLInputElement} */ (document.getElementById("both-time"));
const clock = /** @type {HTMLOutputElement} */ (document.getElementById("both-clock"));
const play = /** @type {HTMLButtonElement} */ (document.getElementById("both-play"));
const frames = /** @type {HTMLIFrameElement[]} */ ([...document.querySelectorAll("iframe.replay")]);
const controls = /** @type {HTMLElement} */ (document.getElementById("both"));
let before = 0; // of the browser's clock [ms]; 0: it stands still

/** Show both at a time [s]; each stays within its own run. */
function show(/** @type {number} */ t) {
  bar.value = String(t);
  bar.setAttribute("aria-valuetext", `${t.toFixed(1)} seconds`);
  clock.textContent = `${t.toFixed(1)} s`;
  for (const frame of frames) frame.contentWindow?.postMessage({ vrts: "show", time_s: t }, "*");
}

function stop() {
  before = 0;
  play.textContent = "Play both";
}

function tick(/** @type {number} */ now) {
  if (!before) return;
  const t = Math.min(Number(bar.max), Number(bar.value) + (now - before) / 1000);
  before = now;
  show(t);
  if (t >= Number(bar.max)) stop();
  else requestAnimationFrame(tick);
}

bar.addEventListener("input", () => { stop(); show(Number(bar.value)); });
play.addEventListener("click", () => {
  if (before) { stop(); return; }
  if (Number(bar.value) >= Number(bar.max)) show(0);
  before = performance.now();
  play.textContent = "Stop both";
  requestAnimationFrame(tick);
});
window.addEventListener("message", (event) => {
  const end = /** @type {unknown} */ (event.data?.vrts === "shown" ? event.data.end_s : null);
  if (!frames.some((frame) => frame.contentWindow === event.source)) return;
  if (typeof end !== "number" || !Number.isFinite(end)) return;
  bar.max = String(Math.max(Number(bar.max), end));
  controls.hidden = false;
});
