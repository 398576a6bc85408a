// The 3D view: takes a description of the scene and states to show. Feeds no data, keeps no time.

import {
  BackSide, BoxGeometry, BufferAttribute, BufferGeometry, Color, DirectionalLight, Fog, Group,
  HemisphereLight, Line, LineBasicMaterial, Mesh, MeshBasicMaterial, NeutralToneMapping, PCFShadowMap,
  PerspectiveCamera, PMREMGenerator, Scene, SphereGeometry, Sprite, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "../vendor/three/OrbitControls.js";
import { BodyFigure, RobotFigure, ghost, tint } from "./figures.js";
import { ground, ruler } from "./ground.js";
import { label } from "./labels.js";
import { THEMES } from "./colors.js";
import { poseFrom } from "./poses.js";
import { FIELD_OF_VIEW, VIEWS, stoodBack } from "./views.js";

/** @typedef {import("./figures.js").BodyData} BodyData */
/** @typedef {import("./replay.js").State} State */

/**
 * @typedef {object} SceneData
 * @property {string} name
 * @property {string} title
 * @property {import("./figures.js").RobotData} robot
 * @property {BodyData[]} bodies
 * @property {number} floor height of the floor [m]
 * @property {{x0: number, x1: number, y0: number, y1: number, z: number} | null} table its top [m]
 * @property {{body: string, X: number[], title: string}[]} goals
 * @property {{name: string, point: number[], radius: number}[]} vias
 */

/** @typedef {{bodies: string[], robot: boolean, point: number[] | null}} Mark what touches */

const CLOSE = [0.62, -0.62, 0.36]; // from a contact to the eye that looks at it [m]
const SOFT_REFLECTING = 0.3; // light from all sides beside what materials reflect
const SOFT_ALONE = 2.2; // in place of it
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;
const SMALLEST = 11; // height of a label with its halo that can be read [px]
const RED = 0xe5322d;
const YELLOW = 0xffd43b;
const GREEN = 0x2f9e44;
const VIA = 0x7048e8;

/** Draws one scene on one canvas. */
export class Viewer {
  /**
   * @param {HTMLCanvasElement} canvas
   * @param {SceneData} data
   * @param {keyof typeof THEMES} theme
   * @param {{reflections?: boolean}} options without reflections the first picture comes sooner; `reflect` adds them
   */
  constructor(canvas, data, theme, { reflections = true } = {}) {
    this.canvas = canvas;
    this.data = data;
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.toneMapping = NeutralToneMapping;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.05, 30);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.maxDistance = 8;
    this.controls.minDistance = 0.3;
    this.controls.addEventListener("change", () => this.requestDraw());
    this.following = false;
    this.pending = false;
    this.gone = false;
    this.drawn = () => {}; // called after each drawing
    this.surroundings = new Group();
    this.scene.add(this.surroundings);
    this.robot = new RobotFigure(data.robot);
    this.scene.add(this.robot.group);
    /** @type {Map<string, BodyFigure>} */
    this.bodies = new Map();
    for (const body of data.bodies) {
      if (body.kind === "floor") continue;
      const figure = new BodyFigure(body);
      figure.show(poseFrom(body.X));
      this.bodies.set(body.name, figure);
      this.scene.add(figure.group);
    }
    this.goals = this.drawGoals();
    this.contact = new Mesh(new SphereGeometry(0.013, 24, 16), new MeshBasicMaterial({ color: YELLOW, depthTest: false, toneMapped: false }));
    this.contact.renderOrder = 20;
    this.contact.visible = false;
    this.scene.add(this.goals, this.contact);
    this.highlighted = "";
    this.light();
    if (reflections) this.reflect();
    this.setTheme(theme);
    this.look("overview");
    this.watch = new ResizeObserver(() => this.resize());
    this.watch.observe(canvas);
    this.resize();
  }

  /** Let materials reflect a soft room. Half of the work of a first picture where no GPU helps. */
  reflect() {
    if (this.scene.environment) return;
    const room = new Scene();
    room.add(new Mesh(new BoxGeometry(10, 10, 6), new MeshBasicMaterial({ color: 0x70757c, side: BackSide })));
    for (const [x, y, z, w, d, h, glow] of [[0, 0, 2.9, 4, 4, 0.1, 6], [4.8, 2, 1, 0.1, 3, 2.5, 5], [-3, -4.8, 1.5, 4, 0.1, 2, 4]]) {
      const panel = new Mesh(new BoxGeometry(w, d, h), new MeshBasicMaterial({ color: new Color(glow, glow, glow) }));
      panel.position.set(x, y, z);
      room.add(panel);
    }
    const maker = new PMREMGenerator(this.renderer);
    this.scene.environment = maker.fromScene(room, 0, 0.1, 100, { size: 64 }).texture;
    maker.dispose();
    if (this.soft) this.soft.intensity = SOFT_REFLECTING;
    this.requestDraw();
  }

  /** Whether the processor draws, for want of a graphics card: what is dear should be left out. */
  get software() {
    const gl = this.renderer.getContext();
    const names = gl.getExtension("WEBGL_debug_renderer_info");
    return SOFTWARE.test(String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER)));
  }

  /** Lights that do not depend on the theme: a sun with shadow, and the sky. */
  light() {
    this.sun = new DirectionalLight(0xfff4e6, 2);
    this.sun.position.set(1.6, -2.2, 4.2);
    this.sun.target.position.set(0.5, 0, -0.6);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    Object.assign(this.sun.shadow.camera, { left: -2.4, right: 2.4, top: 2.4, bottom: -2.4, near: 0.5, far: 9 });
    this.sun.shadow.normalBias = 0.012;
    this.sun.shadow.radius = 2.5;
    this.soft = new HemisphereLight(0xffffff, 0xb9a98f, SOFT_ALONE);
    this.scene.add(this.sun, this.sun.target, this.soft);
  }

  /** @param {keyof typeof THEMES} theme */
  setTheme(theme) {
    const colors = THEMES[theme];
    this.theme = theme;
    this.scene.background = new Color(colors.sky);
    this.scene.fog = new Fog(colors.sky, 5, 9.5);
    this.scene.environmentIntensity = colors.ambient;
    if (this.sun) this.sun.intensity = colors.sun;
    this.surroundings.clear();
    this.surroundings.add(ground(this.data.floor, theme));
    if (this.data.table) this.surroundings.add(ruler(this.data.table, theme));
    this.requestDraw();
  }

  /** Goals as green ghosts with their titles, via points as violet balls. */
  drawGoals() {
    const group = new Group();
    for (const goal of this.data.goals) {
      const body = this.data.bodies.find((candidate) => candidate.name === goal.body);
      if (body) group.add(ghost(body, poseFrom(goal.X), GREEN));
    }
    for (const via of this.data.vias) {
      const ball = new Mesh(new SphereGeometry(via.radius, 32, 16),
        new MeshBasicMaterial({ color: VIA, transparent: true, opacity: 0.22, depthWrite: false }));
      ball.position.fromArray(via.point);
      const sign = label(via.name, { height: 0.05, color: "#7048e8", halo: "#ffffff", bold: true, onTop: true });
      sign.position.fromArray(via.point);
      group.add(ball, sign);
    }
    return group;
  }

  /** @param {boolean} visible whether goals and via points are drawn */
  showGoals(visible) {
    this.goals.visible = visible;
    this.requestDraw();
  }

  /** @param {State} state */
  show(state) {
    this.robot.show(state);
    for (const [name, X] of state.bodies) this.bodies.get(name)?.show(X);
    if (this.following) {
      const tool = new Vector3(state.X_WT[12], state.X_WT[13], state.X_WT[14]);
      this.camera.position.add(tool.clone().sub(this.controls.target));
      this.controls.target.copy(tool);
    }
    this.requestDraw();
  }

  /**
   * Mark what touches: bodies glow red, a dot shows where. Null takes the mark away.
   * @param {Mark | null} mark
   */
  highlight(mark) {
    const key = JSON.stringify(mark);
    if (key === this.highlighted) return;
    this.highlighted = key;
    for (const [name, figure] of this.bodies) tint(figure.group, mark?.bodies.includes(name) ? RED : null);
    tint(this.robot.hand, mark?.robot ? RED : null);
    this.contact.visible = Boolean(mark?.point);
    if (mark?.point) this.contact.position.fromArray(mark.point);
    this.requestDraw();
  }

  /**
   * Draw the path of the tool tip; red where it touches.
   * @param {Float32Array} points x y z of each [m]
   * @param {(index: number) => boolean} touching
   */
  setTrace(points, touching) {
    const colors = new Float32Array(points.length);
    const [free, bad] = [new Color(0x1c7ed6), new Color(RED)];
    for (let i = 0; i < points.length / 3; i++) (touching(i) ? bad : free).toArray(colors, 3 * i);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(points, 3));
    geometry.setAttribute("color", new BufferAttribute(colors, 3));
    if (this.trace) this.scene.remove(this.trace);
    this.trace = new Line(geometry, new LineBasicMaterial({ vertexColors: true, transparent: true, opacity: 0.75 }));
    this.scene.add(this.trace);
    this.requestDraw();
  }

  /** @param {boolean} visible whether the tool's path is drawn */
  showTrace(visible) {
    if (this.trace) this.trace.visible = visible;
    this.requestDraw();
  }

  /** @param {string} name of a view point, or "hand" to follow the tool */
  look(name) {
    this.following = name === "hand";
    const view = VIEWS[/** @type {keyof typeof VIEWS} */ (name)];
    if (view) {
      const { eye, target } = stoodBack(view, this.camera.aspect);
      this.camera.position.fromArray(eye);
      this.controls.target.fromArray(target);
    } else if (this.following) {
      const away = this.camera.position.clone().sub(this.controls.target).setLength(1.1);
      this.camera.position.copy(this.controls.target).add(away);
    }
    this.controls.update();
    this.requestDraw();
  }

  /** Go around what is looked at. @param {number} angle to the left [rad] */
  turn(angle) {
    const away = this.camera.position.clone().sub(this.controls.target);
    this.camera.position.copy(this.controls.target).add(away.applyAxisAngle(this.camera.up, angle));
    this.controls.update();
    this.requestDraw();
  }

  /** Come nearer or step back. @param {number} factor of the distance */
  zoom(factor) {
    const away = this.camera.position.clone().sub(this.controls.target);
    this.camera.position.copy(this.controls.target).add(away.multiplyScalar(factor));
    this.controls.update();
    this.requestDraw();
  }

  /**
   * Draw a state from near what touches onto another canvas. What this view shows has to be shown
   * again afterwards.
   * @param {HTMLCanvasElement} canvas @param {State} state @param {Mark | null} mark
   */
  snapshot(canvas, state, mark) {
    const [eye, target, following] = [this.camera.position.clone(), this.controls.target.clone(), this.following];
    this.following = false;
    this.show(state);
    this.highlight(mark);
    if (mark?.point) {
      this.camera.position.fromArray(mark.point).add(new Vector3().fromArray(CLOSE));
      this.camera.lookAt(new Vector3().fromArray(mark.point));
    }
    this.draw();
    const { width, height } = this.canvas;
    const share = Math.min(width / canvas.width, height / canvas.height);
    const [w, h] = [canvas.width * share, canvas.height * share];
    canvas.getContext("2d")?.drawImage(this.canvas, (width - w) / 2, (height - h) / 2, w, h, 0, 0, canvas.width, canvas.height);
    this.camera.position.copy(eye);
    this.controls.target.copy(target);
    this.controls.update();
    this.following = following;
  }

  /** Take the canvas's size on the page. */
  resize() {
    const { clientWidth, clientHeight } = this.canvas;
    if (!clientWidth || !clientHeight) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /** Draw once, at the next frame. */
  requestDraw() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => this.draw());
  }

  /** Draw now. */
  draw() {
    this.pending = false;
    if (this.gone) return;
    this.hideSmall();
    this.renderer.render(this.scene, this.camera);
    this.drawn();
  }

  /** Leave out numbers on floor and table that are too small to be read. */
  hideSmall() {
    const seen = this.canvas.clientHeight / (2 * Math.tan((this.camera.fov * Math.PI) / 360)); // [px] of 1 m at 1 m
    this.surroundings.traverse((part) => {
      if (part instanceof Sprite) part.visible = (seen * part.scale.y) / part.position.distanceTo(this.camera.position) > SMALLEST;
    });
  }

  /** Draw no more, and give the graphics card's memory back. */
  dispose() {
    this.gone = true;
    this.watch.disconnect();
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}
