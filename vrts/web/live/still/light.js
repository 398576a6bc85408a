// Light on flat faces, as the 3D view has it before anything reflects: a sun, a sky, a floor that fades.

/** @typedef {number[]} Rgb linear red, green and blue, 0..1 */
/** @typedef {number[]} Point x, y and z [m] */

const SUN = [0.204, -0.408, 0.89]; // direction to it, of length 1
const SUN_COLOR = rgb(0xfff4e6);
const SKY = rgb(0xffffff); // from y, as three.js hangs it
const BELOW = rgb(0xb9a98f);
const SKY_LIGHT = 2.2;
const FOG = [5, 9.5]; // depths in which the floor fades into the sky [m]

/** Return a colour as light. @param {number} hex @returns {Rgb} */
export function rgb(hex) {
  return [hex >> 16, hex >> 8, hex].map((part) => {
    const value = (part & 255) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  });
}

/**
 * Return the colour on the screen of what lies flat, 0..255.
 * @param {Point} normal the way out of it, of length 1 @param {Rgb} color @param {number} sun how bright it is
 */
export function lit(normal, color, sun) {
  const direct = sun * Math.max(0, normal[0] * SUN[0] + normal[1] * SUN[1] + normal[2] * SUN[2]);
  const share = 0.5 + 0.5 * normal[1];
  return shown(color.map((part, k) => (part / Math.PI) * (direct * SUN_COLOR[k] + SKY_LIGHT * (BELOW[k] + share * (SKY[k] - BELOW[k])))));
}

/** Return how much of a colour is left at a depth. @param {number} depth [m] */
export function clear(depth) {
  const share = Math.min(Math.max((depth - FOG[0]) / (FOG[1] - FOG[0]), 0), 1);
  return 1 - share * share * (3 - 2 * share);
}

/** Return light as a screen shows it: bright parts are held back, as the 3D view does. @param {Rgb} light */
function shown(light) {
  const least = Math.min(...light);
  const offset = least < 0.08 ? least - 6.25 * least * least : 0.04;
  const most = Math.max(...light) - offset;
  const scale = most < 0.76 ? 1 : (1 - 0.0576 / (most - 0.52)) / most;
  return light.map((part) => {
    const value = Math.min(Math.max((part - offset) * scale, 0), 1);
    return Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055));
  });
}
