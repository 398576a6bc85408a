// The first picture: the arm as the page brought it, until the 3D view has drawn it.

import { PROJECTED, keptLayout } from "../layout/kept.js";
import { theme } from "../themes.js";
import { carried } from "./carried.js";
import { drawn } from "./drawing.js";
import { notReady, onStillEnd } from "./ended.js";

const EARLY = "early"; // class of a page that shows it
const FINEST = 2; // pixels to a dot of the page, each way
const MOST = 350_000; // pixels that are drawn
const NARROW = window.matchMedia("(max-width: 960px) and (not ((max-height: 520px) and (orientation: landscape)))");
const PATIENCE = 60_000; // after which a picture that nothing has followed is no picture of now [ms]

/** Show the room with its first picture, if the page brought one. */
export function showStill() {
  const still = carried()?.still;
  const [room, view] = [document.getElementById("room"), document.getElementById("view")];
  if (!still || !room || !view) return;
  room.hidden = false;
  document.body.classList.add(EARLY);
  notReady();
  const layout = keptLayout();
  arrange(room, layout);
  const projector = new URLSearchParams(location.search).has("projector");
  document.body.classList.toggle("projector", projector);
  const canvas = document.createElement("canvas");
  canvas.className = "still";
  canvas.setAttribute("aria-hidden", "true");
  view.prepend(canvas);
  const draw = () => {
    try {
      drawOn(canvas, still, projector ? PROJECTED : layout.look);
    } catch (problem) {
      end(); // a picture that cannot be drawn hides nothing
      console.error("the first picture could not be drawn:", problem);
    }
  };
  const watch = new ResizeObserver(draw);
  const end = () => {
    watch.disconnect();
    canvas.remove();
    document.body.classList.remove(EARLY);
  };
  onStillEnd(end);
  setTimeout(end, PATIENCE);
  watch.observe(view);
  draw();
}

/** Make the page's parts as large as they will be. @param {HTMLElement} room @param {import("../layout/kept.js").Layout} layout */
function arrange(room, layout) {
  room.style.setProperty("--desk", `${layout.desk}px`);
  if (layout.deskHigh) room.style.setProperty("--desk-high", `${layout.deskHigh}px`);
  room.style.setProperty("--terminal", `${layout.terminal}px`);
  room.classList.toggle("desk-folded", layout.deskFolded);
  room.classList.toggle("terminal-folded", layout.terminalFolded);
  document.getElementById("desk-border")?.setAttribute("aria-orientation", NARROW.matches ? "horizontal" : "vertical");
}

/** @param {HTMLCanvasElement} canvas @param {import("./carried.js").Still} still @param {string} look */
function drawOn(canvas, still, look) {
  const { clientWidth, clientHeight } = canvas;
  if (!clientWidth || !clientHeight) return;
  const scale = Math.min(FINEST, Math.sqrt(MOST / (clientWidth * clientHeight)));
  const [width, height] = [Math.round(clientWidth * scale), Math.round(clientHeight * scale)];
  if (canvas.width === width && canvas.height === height) return;
  [canvas.width, canvas.height] = [width, height];
  const picture = new ImageData(drawn(still.scene, still, look, width, height, theme()), width, height);
  canvas.getContext("2d")?.putImageData(picture, 0, 0);
}
