// What need not wait for the rest of the page: the colours that were chosen, a first picture, and the
// canvas's WebGL context, whose making takes about as long as the modules are on their way.

import { endStill } from "./still/ended.js";
import { showStill } from "./still/still.js";
import { applyTheme, chosenTheme } from "./themes.js";

const VIEW = "#canvas";
/** As three.js asks for it: a canvas keeps the first context it is given. @type {WebGLContextAttributes} */
const AS_THREE = {
  alpha: true, depth: true, stencil: false, antialias: true, premultipliedAlpha: true, preserveDrawingBuffer: false,
  powerPreference: "default", failIfMajorPerformanceCaveat: false,
};

/** Make the context. */
function prepare() {
  /** @type {HTMLCanvasElement | null} */ (document.querySelector(VIEW))?.getContext("webgl2", AS_THREE);
}

applyTheme(chosenTheme());
try {
  showStill();
} catch (problem) {
  endStill();
  console.error("there is no first picture:", problem);
}
if (location.pathname !== "/admin" && !new URLSearchParams(location.search).has("wall")) {
  requestAnimationFrame(() => setTimeout(prepare)); // after the first picture
}
