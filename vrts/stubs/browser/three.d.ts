// The part of three.js that the pages use, for the type checker: `python -m tests browser-types`.
// Written by hand after https://threejs.org/docs (release 0.185).

type Triple = [number, number, number];
type Paint = number | string | Color;

export const BackSide: number;
export const DoubleSide: number;
export const NeutralToneMapping: number;
export const PCFShadowMap: number;
export const SRGBColorSpace: string;

export class Color {
  constructor(color?: Paint);
  constructor(r: number, g: number, b: number);
  r: number;
  g: number;
  b: number;
  set(color: Paint): this;
  setHex(hex: number): this;
  setRGB(r: number, g: number, b: number): this;
  copy(color: Color): this;
  clone(): Color;
  getStyle(): string;
  toArray<T extends ArrayLike<number>>(array?: T, offset?: number): T;
}

export class Vector2 {
  constructor(x?: number, y?: number);
  x: number;
  y: number;
  set(x: number, y: number): this;
}

export class Vector3 {
  constructor(x?: number, y?: number, z?: number);
  x: number;
  y: number;
  z: number;
  set(x: number, y: number, z: number): this;
  setZ(z: number): this;
  copy(v: Vector3): this;
  clone(): Vector3;
  add(v: Vector3): this;
  addScaledVector(v: Vector3, s: number): this;
  sub(v: Vector3): this;
  subVectors(a: Vector3, b: Vector3): this;
  lerpVectors(a: Vector3, b: Vector3, share: number): this;
  negate(): this;
  setScalar(s: number): this;
  multiplyScalar(s: number): this;
  applyMatrix4(m: Matrix4): this;
  applyQuaternion(q: Quaternion): this;
  applyAxisAngle(axis: Vector3, angle: number): this;
  cross(v: Vector3): this;
  crossVectors(a: Vector3, b: Vector3): this;
  dot(v: Vector3): number;
  length(): number;
  lengthSq(): number;
  setLength(length: number): this;
  distanceTo(v: Vector3): number;
  angleTo(v: Vector3): number;
  normalize(): this;
  project(camera: Camera): this;
  unproject(camera: Camera): this;
  fromArray(array: ArrayLike<number>, offset?: number): this;
  toArray(): Triple;
  toArray<T extends { [index: number]: number }>(array: T, offset?: number): T;
  fromBufferAttribute(attribute: BufferAttribute, index: number): this;
  setFromMatrixPosition(m: Matrix4): this;
  setFromMatrixColumn(m: Matrix4, index: number): this;
  [Symbol.iterator](): Iterator<number>;
}

export class Quaternion {
  constructor(x?: number, y?: number, z?: number, w?: number);
  copy(q: Quaternion): this;
  setFromRotationMatrix(m: Matrix4): this;
  setFromUnitVectors(from: Vector3, to: Vector3): this;
  setFromAxisAngle(axis: Vector3, angle: number): this;
}

export class Matrix4 {
  elements: number[];
  fromArray(array: ArrayLike<number>): this;
  copy(m: Matrix4): this;
  invert(): this;
  multiply(m: Matrix4): this;
  makeBasis(x: Vector3, y: Vector3, z: Vector3): this;
}

export class Plane {
  constructor(normal?: Vector3, constant?: number);
  normal: Vector3;
  setFromNormalAndCoplanarPoint(normal: Vector3, point: Vector3): this;
}

export class Box3 {
  min: Vector3;
  max: Vector3;
  setFromObject(object: Object3D): this;
}

export class Ray {
  origin: Vector3;
  direction: Vector3;
  intersectPlane(plane: Plane, target: Vector3): Vector3 | null;
  distanceSqToPoint(point: Vector3): number;
  distanceSqToSegment(a: Vector3, b: Vector3, onRay?: Vector3, onSegment?: Vector3): number;
}

export interface Hit {
  distance: number;
  point: Vector3;
  object: Object3D;
}

export class Raycaster {
  ray: Ray;
  setFromCamera(point: Vector2, camera: Camera): void;
  intersectObject(object: Object3D, recursive?: boolean): Hit[];
  intersectObjects(objects: Object3D[], recursive?: boolean): Hit[];
}

export class Object3D {
  name: string;
  parent: Object3D | null;
  children: Object3D[];
  up: Vector3;
  position: Vector3;
  quaternion: Quaternion;
  scale: Vector3;
  matrix: Matrix4;
  matrixWorld: Matrix4;
  matrixAutoUpdate: boolean;
  matrixWorldNeedsUpdate: boolean;
  visible: boolean;
  castShadow: boolean;
  receiveShadow: boolean;
  renderOrder: number;
  frustumCulled: boolean;
  userData: Record<string, any>;
  add(...objects: Object3D[]): this;
  remove(...objects: Object3D[]): this;
  clear(): this;
  removeFromParent(): this;
  lookAt(v: Vector3): void;
  traverse(call: (object: Object3D) => void): void;
  applyMatrix4(m: Matrix4): void;
  updateMatrixWorld(force?: boolean): void;
  getWorldDirection(target: Vector3): Vector3;
  getWorldPosition(target: Vector3): Vector3;
}

export class Group extends Object3D {}

export class Fog {
  constructor(color: Paint, near?: number, far?: number);
}

export class Scene extends Object3D {
  background: Color | Texture | null;
  environment: Texture | null;
  environmentIntensity: number;
  fog: Fog | null;
}

export class Camera extends Object3D {
  matrixWorldInverse: Matrix4;
  projectionMatrix: Matrix4;
}

export class PerspectiveCamera extends Camera {
  constructor(fov?: number, aspect?: number, near?: number, far?: number);
  aspect: number;
  fov: number;
  near: number;
  updateProjectionMatrix(): void;
}

export class Texture {
  colorSpace: string;
  anisotropy: number;
  image: any;
  needsUpdate: boolean;
  dispose(): void;
}

export class CanvasTexture extends Texture {
  constructor(canvas: HTMLCanvasElement);
}

export class BufferAttribute {
  constructor(array: ArrayLike<number>, size: number);
  array: Float32Array;
  count: number;
  needsUpdate: boolean;
  getX(index: number): number;
  getY(index: number): number;
  getZ(index: number): number;
  setXYZ(index: number, x: number, y: number, z: number): this;
}

export class BufferGeometry {
  boundingBox: Box3 | null;
  computeBoundingBox(): void;
  setAttribute(name: string, attribute: BufferAttribute): this;
  getAttribute(name: string): BufferAttribute;
  deleteAttribute(name: string): this;
  setFromPoints(points: Vector3[]): this;
  applyMatrix4(m: Matrix4): this;
  rotateX(angle: number): this;
  rotateY(angle: number): this;
  rotateZ(angle: number): this;
  translate(x: number, y: number, z: number): this;
  dispose(): void;
}

export class BoxGeometry extends BufferGeometry {
  constructor(w?: number, h?: number, d?: number, wCuts?: number, hCuts?: number, dCuts?: number);
}
export class CircleGeometry extends BufferGeometry {
  constructor(radius?: number, segments?: number);
}
export class ConeGeometry extends BufferGeometry {
  constructor(radius?: number, height?: number, segments?: number);
}
export class CylinderGeometry extends BufferGeometry {
  constructor(top?: number, bottom?: number, height?: number, segments?: number, cuts?: number, open?: boolean);
}
export class EdgesGeometry extends BufferGeometry {
  constructor(geometry: BufferGeometry, thresholdDegrees?: number);
}
export class LatheGeometry extends BufferGeometry {
  constructor(points: Vector2[], segments?: number);
}
export class OctahedronGeometry extends BufferGeometry {
  constructor(radius?: number);
}
export class PlaneGeometry extends BufferGeometry {
  constructor(width?: number, height?: number);
}
export class RingGeometry extends BufferGeometry {
  constructor(inner?: number, outer?: number, segments?: number, cuts?: number, start?: number, length?: number);
}
export class SphereGeometry extends BufferGeometry {
  constructor(radius?: number, widthSegments?: number, heightSegments?: number);
}
export class TorusGeometry extends BufferGeometry {
  constructor(radius?: number, tube?: number, radial?: number, tubular?: number, arc?: number);
}

export interface MaterialLook {
  color?: Paint;
  transparent?: boolean;
  opacity?: number;
  side?: number;
  depthTest?: boolean;
  depthWrite?: boolean;
  toneMapped?: boolean;
  fog?: boolean;
  vertexColors?: boolean;
}

export class Material {
  transparent: boolean;
  opacity: number;
  visible: boolean;
  depthTest: boolean;
  needsUpdate: boolean;
  dispose(): void;
}

export class MeshBasicMaterial extends Material {
  constructor(look?: MaterialLook);
  color: Color;
}
export class MeshStandardMaterial extends Material {
  constructor(look?: MaterialLook & { roughness?: number; metalness?: number });
  color: Color;
  emissive: Color;
  emissiveIntensity: number;
}
export class LineBasicMaterial extends Material {
  constructor(look?: MaterialLook);
  color: Color;
}
export class LineDashedMaterial extends LineBasicMaterial {
  constructor(look?: MaterialLook & { dashSize?: number; gapSize?: number });
}
export class SpriteMaterial extends Material {
  constructor(look?: MaterialLook & { map?: Texture; sizeAttenuation?: boolean });
  color: Color;
  map: Texture | null;
}

export class Mesh<M extends Material | Material[] = Material> extends Object3D {
  constructor(geometry?: BufferGeometry, material?: M);
  geometry: BufferGeometry;
  material: M;
}

export class Line<M extends Material = Material> extends Object3D {
  constructor(geometry?: BufferGeometry, material?: M);
  geometry: BufferGeometry;
  material: M;
  computeLineDistances(): this;
}
export class LineSegments<M extends Material = Material> extends Line<M> {}

export class Sprite extends Object3D {
  constructor(material?: SpriteMaterial);
  material: SpriteMaterial;
  center: Vector2;
}

export class ArrowHelper extends Object3D {
  constructor(way: Vector3, origin: Vector3, length?: number, color?: Paint, headLength?: number, headWidth?: number);
}

export class HemisphereLight extends Object3D {
  constructor(sky?: Paint, ground?: Paint, intensity?: number);
  intensity: number;
}

export class DirectionalLight extends Object3D {
  constructor(color?: Paint, intensity?: number);
  intensity: number;
  target: Object3D;
  shadow: { mapSize: Vector2; camera: Camera; normalBias: number; radius: number };
}

export class PMREMGenerator {
  constructor(renderer: WebGLRenderer);
  fromScene(scene: Scene, sigma?: number, near?: number, far?: number, options?: { size?: number }): { texture: Texture };
  dispose(): void;
}

export class WebGLRenderer {
  constructor(options?: { canvas?: HTMLCanvasElement; antialias?: boolean });
  domElement: HTMLCanvasElement;
  getContext(): WebGL2RenderingContext;
  shadowMap: { enabled: boolean; type: number };
  toneMapping: number;
  setPixelRatio(ratio: number): void;
  setSize(width: number, height: number, style?: boolean): void;
  render(scene: Scene, camera: Camera): void;
  dispose(): void;
  forceContextLoss(): void;
}
