// Pose frames: 49 bytes, little endian, fifty times a second.

const KIND = 1;
const VERSION = 1;
const SIZE = 49; // bytes

export const RUNNING = 1; // a program executes
export const MOVING = 2;
export const STOPPING = 4;
export const HOLDING = 8;

/** Return the numbers of the outputs that are on. @param {number} outputs as bits */
export function onIn(outputs) {
  return Array.from({ length: 32 }, (_, bit) => bit).filter((bit) => (outputs >>> bit) & 1).map((bit) => bit + 1);
}

/**
 * @typedef {object} PoseFrame
 * @property {number} session
 * @property {number} sequence
 * @property {number} time of the session [s]
 * @property {number[]} joints six [rad]
 * @property {number} hand opening [m]
 * @property {number} outputs bit 0 is output 1
 * @property {number} flags
 */

/**
 * Return the frame that bytes hold; null when they hold none of this version.
 * @param {ArrayBuffer} data
 * @returns {PoseFrame | null}
 */
export function unpacked(data) {
  if (data.byteLength !== SIZE) return null;
  const view = new DataView(data);
  if (view.getUint8(0) !== KIND || view.getUint8(1) !== VERSION) return null;
  return {
    session: view.getUint16(2, true),
    sequence: view.getUint32(4, true),
    time: view.getFloat64(8, true),
    joints: [0, 1, 2, 3, 4, 5].map((joint) => view.getFloat32(16 + 4 * joint, true)),
    hand: view.getFloat32(40, true),
    outputs: view.getUint32(44, true),
    flags: view.getUint8(48),
  };
}
