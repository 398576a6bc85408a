// Words in the scene: sprites that always face the viewer.

import { CanvasTexture, Sprite, SpriteMaterial, SRGBColorSpace } from "three";

const PIXELS = 64; // height of a line of text in the texture

/**
 * Return a sprite that shows a text.
 * @param {string} text
 * @param {{height: number, color: string, halo: string, bold?: boolean, onTop?: boolean}} style height [m]
 */
export function label(text, { height, color, halo, bold = false, onTop = false }) {
  const canvas = document.createElement("canvas");
  const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const font = `${bold ? "600 " : ""}${PIXELS * 0.62}px system-ui, sans-serif`;
  pen.font = font;
  canvas.width = Math.ceil(pen.measureText(text).width) + PIXELS * 0.5;
  canvas.height = PIXELS;
  pen.font = font;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.lineJoin = "round";
  pen.lineWidth = PIXELS * 0.16;
  pen.strokeStyle = halo;
  pen.strokeText(text, canvas.width / 2, PIXELS / 2);
  pen.fillStyle = color;
  pen.fillText(text, canvas.width / 2, PIXELS / 2);
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  const material = new SpriteMaterial({ map, transparent: true, depthTest: !onTop, depthWrite: false });
  const sprite = new Sprite(material);
  sprite.scale.set((height * canvas.width) / canvas.height, height, 1);
  sprite.renderOrder = 10;
  return sprite;
}
