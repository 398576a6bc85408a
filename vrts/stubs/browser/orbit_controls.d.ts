// The part of three.js' OrbitControls that the pages use, for the type checker.

import type { Camera, Vector3 } from "three";

export class OrbitControls {
  constructor(camera: Camera, element: HTMLElement);
  enabled: boolean;
  target: Vector3;
  minDistance: number;
  maxDistance: number;
  enableDamping: boolean;
  maxPolarAngle: number;
  addEventListener(name: "change" | "start" | "end", tell: () => void): void;
  update(): boolean;
  dispose(): void;
}
