// What need not wait for the rest of the page: the colours that were chosen, and the canvas's WebGL
// context, whose making takes about as long as the modules are on their way.

import { applyTheme, chosenTheme } from "./themes.js";

const VIEW = "#canvas";
/** As three.js asks for it: a canvas keeps the first context it is given. @type {WebGLContextAttributes} */
const AS_THREE = {
  alpha: true, depth: true, stencil: false, antialias: true, premultipliedAlpha: true, preserveDrawingBuffer: false,
  powerPreference: "default", failIfMajorPerformanceCaveat: false,
};

applyTheme(chosenTheme());
if (location.pathname !== "/admin" && !new URLSearchParams(location.search).has("wall")) {
  /** @type {HTMLCanvasElement | null} */ (document.querySelector(VIEW))?.getContext("webgl2", AS_THREE);
}
