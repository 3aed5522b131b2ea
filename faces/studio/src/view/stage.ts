// SPDX-License-Identifier: MIT
// The drawing table in three.js: paper ground, a movable light, the characters. It draws only when something changed.
import * as THREE from 'three';
import type { PartGeometry } from '../engine/messages';
import type { ActorInfo, PoseFrame } from '../engine/protocol';
import { CameraRig, type Insets } from './camera_rig';
import { CharacterView } from './character_view';
import { Ground } from './ground';
import { readVertices } from './read_vertices';

export interface StageTheme {
  paper: string;
  shade: string;
  strength: number;
}

/** A part of the canvas, CSS pixels from its top-left corner. */
export interface Frame {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** `draft` halves the resolution: for very slow machines, and for tests on software renderers. */
export type Quality = 'full' | 'draft';

export class Stage {
  readonly rig = new CameraRig();
  readonly characters = new Map<number, CharacterView>();
  readonly renderer: THREE.WebGLRenderer;
  /** Pictures drawn so far, and what the last one cost; tests and `?perf` read them. */
  readonly stats = { frames: 0, drawCalls: 0, drawMs: 0 };
  /** What panels cover of the canvas: a character is framed in what is left. */
  insets: Insets = { left: 0, right: 0, top: 0, bottom: 0 };
  onDrawn: () => void = () => {};

  private readonly scene = new THREE.Scene();
  private readonly sun = new THREE.DirectionalLight(0xffffff, 1);
  private readonly ground = new Ground();
  private readonly plane: THREE.Mesh<THREE.PlaneGeometry, THREE.MeshBasicMaterial>;
  private waiting = false;
  private mini: (() => Frame | null) | null = null;
  private planeNormal: () => THREE.Vector3 | null = () => null;

  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly quality: Quality = 'full',
  ) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: quality === 'full', alpha: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.BasicShadowMap; // the materials here filter it themselves
    this.renderer.shadowMap.autoUpdate = false;
    this.renderer.toneMapping = THREE.NoToneMapping;
    this.renderer.info.autoReset = false;
    this.plane = new THREE.Mesh(
      new THREE.PlaneGeometry(1, 1),
      new THREE.MeshBasicMaterial({ color: 0x3a6ea5, transparent: true, opacity: 0.08, side: THREE.DoubleSide, depthWrite: false }),
    );
    this.plane.visible = false;
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.setScalar(quality === 'full' ? 1536 : 512);
    this.scene.add(this.sun, this.sun.target, this.ground.mesh, this.plane);
    this.rig.onChange = () => this.invalidate();
    this.setLight(-0.42, 0.91);
  }

  setTheme(theme: StageTheme): void {
    this.ground.setShade(theme.shade, theme.strength);
    this.invalidate();
  }

  /** The light's heading and elevation, radians, about the scene's middle. */
  setLight(heading: number, elevation: number): void {
    const level = Math.cos(elevation);
    this.sun.userData['direction'] = new THREE.Vector3(Math.sin(heading) * level, Math.sin(elevation), Math.cos(heading) * level);
    this.fitScene();
  }

  resize(width: number, height: number, ratio: number): void {
    this.renderer.setPixelRatio(this.quality === 'full' ? ratio : 0.5);
    this.renderer.setSize(width, height, false);
    this.rig.resize(width, height);
    this.invalidate();
  }

  async addCharacter(info: ActorInfo, geometry: (part: number) => Promise<PartGeometry>): Promise<void> {
    const view = new CharacterView(info);
    for (let part = 0; part < info.parts.length; ++part) await view.addPart(part, await geometry(part));
    this.removeCharacter(info.id);
    this.characters.set(info.id, view);
    this.scene.add(view.group);
    this.fitScene();
  }

  removeCharacter(id: number): void {
    const view = this.characters.get(id);
    if (!view) return;
    this.scene.remove(view.group);
    view.dispose();
    this.characters.delete(id);
    this.fitScene();
  }

  show(frames: PoseFrame[]): void {
    for (const frame of frames) this.characters.get(frame.actor)?.show(frame);
    if (frames.length > 0) this.fitScene();
  }

  readVertices(actor: number, part: number): Float32Array {
    return readVertices(this.renderer, this.characters.get(actor)!, part);
  }

  /** The box around all joints, in the scene. */
  bounds(actor?: number): THREE.Box3 {
    const box = new THREE.Box3();
    for (const [id, view] of this.characters) if (actor === undefined || id === actor) box.union(view.bounds());
    if (box.isEmpty()) box.set(new THREE.Vector3(-0.5, 0, -0.5), new THREE.Vector3(0.5, 1.8, 0.5));
    return box;
  }

  frame(actor?: number): void {
    this.rig.frame(this.bounds(actor), this.insets);
  }

  /** The plane that lines are drawn in: its normal now, null where none is to be shown. */
  setPlane(normal: () => THREE.Vector3 | null): void {
    this.planeNormal = normal;
    this.invalidate();
  }

  private placePlane(): void {
    const normal = this.planeNormal();
    this.plane.visible = normal !== null;
    if (!normal) return;
    const box = this.bounds();
    const centre = box.getCenter(new THREE.Vector3());
    this.plane.position.copy(centre);
    this.plane.lookAt(centre.clone().add(normal));
    this.plane.scale.setScalar(1.4 * box.getSize(new THREE.Vector3()).length());
  }

  /** Where the view from the side goes; it is drawn into the same canvas. */
  setMini(place: (() => Frame | null) | null): void {
    this.mini = place;
    this.invalidate();
  }

  invalidate(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      if (this.waiting) this.draw();
    });
  }

  /** Draws what stands on the table over what a canvas holds, in its size; with or without the shadow on the ground. */
  drawOnto(canvas: HTMLCanvasElement, bare: boolean): void {
    const size = this.renderer.getSize(new THREE.Vector2());
    const ratio = this.renderer.getPixelRatio();
    const { plane, ground } = this;
    const shown = [plane.visible, ground.mesh.visible] as const;
    [plane.visible, ground.mesh.visible] = [false, !bare];
    this.renderer.setPixelRatio(1);
    this.renderer.setSize(canvas.width, canvas.height, false);
    this.rig.resize(canvas.width, canvas.height);
    this.renderer.render(this.scene, this.rig.camera);
    canvas.getContext('2d')!.drawImage(this.canvas, 0, 0);
    [plane.visible, ground.mesh.visible] = shown;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(size.x, size.y, false);
    this.rig.resize(size.x, size.y);
    this.draw();
  }

  /** Small square pictures of one character in other poses, drawn through the canvas, which shows the table again at
      once. `focus` names the joints to look at, all of them where it is empty. */
  thumbnails(actor: number, poses: { frame: PoseFrame; focus: number[] }[], pixels: number): HTMLCanvasElement[] {
    const view = this.characters.get(actor);
    if (!view) return [];
    const now: PoseFrame = { actor, palette: view.texels, joints: view.joints };
    const others = this.scene.children.filter((child) => child !== view.group && child !== this.sun && child !== this.sun.target && child.visible);
    for (const other of others) other.visible = false;
    const side = Math.min(pixels / this.renderer.getPixelRatio(), this.canvas.clientWidth, this.canvas.clientHeight);
    const pictures = poses.map(({ frame, focus }) => {
      view.show(frame);
      this.aimSun(view.bounds());
      const box = focus.length > 0 ? view.bounds(focus) : view.bounds();
      const camera = focus.length > 0 ? squareCamera(box, -0.5, 1, 0.75) : squareCamera(box, Math.PI / 5);
      this.drawInto({ x: 0, y: 0, width: side, height: side }, camera);
      const copy = document.createElement('canvas');
      copy.width = copy.height = pixels;
      const drawn = side * this.renderer.getPixelRatio();
      copy.getContext('2d')!.drawImage(this.canvas, 0, 0, drawn, drawn, 0, 0, pixels, pixels);
      return copy;
    });
    for (const other of others) other.visible = true;
    view.show(now);
    this.fitScene();
    this.draw();
    return pictures;
  }

  private draw(): void {
    this.waiting = false;
    const started = performance.now();
    this.renderer.info.reset();
    this.placePlane();
    this.renderer.render(this.scene, this.rig.camera);
    const place = this.mini?.();
    if (place) this.drawInto(place, squareCamera(this.bounds(), this.rig.state.heading + Math.PI / 2, place.width / place.height));
    this.stats.frames += 1;
    this.stats.drawCalls = this.renderer.info.render.calls;
    this.stats.drawMs = performance.now() - started;
    this.onDrawn();
  }

  private drawInto(place: Frame, camera: THREE.Camera): void {
    const size = this.renderer.getSize(new THREE.Vector2());
    const bottom = size.y - place.y - place.height;
    this.renderer.setViewport(place.x, bottom, place.width, place.height);
    this.renderer.setScissor(place.x, bottom, place.width, place.height);
    this.renderer.setScissorTest(true);
    this.renderer.render(this.scene, camera);
    this.renderer.setScissorTest(false);
    this.renderer.setViewport(0, 0, size.x, size.y);
  }

  /** Ground, light and shadow sized to what stands on the table. */
  private fitScene(): void {
    const box = this.bounds();
    const size = box.getSize(new THREE.Vector3()).length();
    const centre = box.getCenter(new THREE.Vector3());
    const lowest = Math.min(...[...this.characters.values()].map((view) => view.floor()));
    const ground = Number.isFinite(lowest) ? lowest : 0;
    this.ground.place(centre, ground, 3 * size);
    this.ground.setTouches([...this.characters.values()].flatMap((view) => view.points()), 0.035 * size);
    this.aimSun(box);
    this.invalidate();
  }

  private aimSun(box: THREE.Box3): void {
    const size = box.getSize(new THREE.Vector3()).length();
    const centre = box.getCenter(new THREE.Vector3());
    const direction = this.sun.userData['direction'] as THREE.Vector3;
    this.sun.target.position.copy(centre);
    this.sun.position.copy(centre).addScaledVector(direction, 2 * size);
    const half = 0.75 * size;
    Object.assign(this.sun.shadow.camera, { left: -half, right: half, top: half, bottom: -half, near: size, far: 3.6 * size });
    this.sun.shadow.camera.updateProjectionMatrix();
    this.sun.shadow.normalBias = 0.006 * size;
    this.sun.shadow.bias = -0.0008;
    this.renderer.shadowMap.needsUpdate = true;
  }
}

/** Looks at the middle of a box, about level, without perspective, the whole of it in the picture. */
function squareCamera(box: THREE.Box3, heading: number, aspect = 1, elevation = 0.08): THREE.OrthographicCamera {
  const size = box.getSize(new THREE.Vector3());
  const across = Math.abs(Math.cos(heading)) * size.x + Math.abs(Math.sin(heading)) * size.z;
  const half = 0.56 * Math.max(size.y, across / aspect, 1e-6);
  const far = 20 * size.length();
  const camera = new THREE.OrthographicCamera(-half * aspect, half * aspect, half, -half, -far, far);
  const centre = box.getCenter(new THREE.Vector3());
  camera.position.copy(centre).add(new THREE.Vector3(Math.sin(heading), Math.tan(elevation), Math.cos(heading)).multiplyScalar(half));
  camera.lookAt(centre);
  camera.updateMatrixWorld();
  return camera;
}
