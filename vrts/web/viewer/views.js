// From where a scene is looked at.

export const FIELD_OF_VIEW = 36; // of the height of the picture [deg]

/** Preset view points: where the eye stands and what it looks at [m]. */
export const VIEWS = {
  overview: { eye: [3.0, -2.5, 1.15], target: [0.5, 0, -0.06] },
  front: { eye: [4.2, 0, 0.35], target: [0.4, 0, -0.02] },
  side: { eye: [0.5, -4.1, 0.3], target: [0.5, 0, -0.02] },
  table: { eye: [2.25, -1.35, 0.75], target: [0.95, 0, -0.22] },
  top: { eye: [0.7, -0.01, 3.8], target: [0.7, 0, 0] },
};

const WIDTH = 1.25; // narrower pictures than this, by height, are seen from farther away

/**
 * Return a view as it is stood at: farther back where the picture is narrow, so that the same width is seen.
 * @param {{eye: number[], target: number[]}} view [m] @param {number} aspect of the picture, width by height
 * @returns {{eye: number[], target: number[]}} [m]
 */
export function stoodBack({ eye, target }, aspect) {
  const factor = Math.max(1, WIDTH / aspect);
  return { eye: target.map((middle, axis) => middle + (eye[axis] - middle) * factor), target: [...target] };
}
