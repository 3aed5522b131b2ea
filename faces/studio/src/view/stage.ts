// SPDX-License-Identifier: MIT
// The drawing table in three.js: paper ground, a movable light, the characters. It draws only when something changed.
import * as THREE from 'three';
import type { PartGeometry } from '../engine/messages';
import type { ActorInfo, PoseFrame } from '../engine/protocol';
import { CameraRig } from './camera_rig';
import { CharacterView } from './character_view';

export interface StageTheme {
  paper: string;
  ground: string;
  grid: string;
}

export class Stage {
  readonly rig = new CameraRig();
  readonly characters = new Map<number, CharacterView>();
  readonly renderer: THREE.WebGLRenderer;
  /** Pictures drawn so far, and what the last one cost; tests and `?perf` read them. */
  readonly stats = { frames: 0, drawCalls: 0, drawMs: 0 };
  onDrawn: () => void = () => {};

  private readonly scene = new THREE.Scene();
  private readonly sun = new THREE.DirectionalLight(0xfff4e6, 2.4);
  private readonly sky = new THREE.HemisphereLight(0xf2f6ff, 0xd9cbb8, 1.35);
  private readonly ground: THREE.Mesh<THREE.CircleGeometry, THREE.ShadowMaterial>;
  private readonly paper: THREE.Mesh<THREE.CircleGeometry, THREE.MeshBasicMaterial>;
  private readonly plane: THREE.Mesh<THREE.PlaneGeometry, THREE.MeshBasicMaterial>;
  private waiting = false;
  private mini: HTMLCanvasElement | null = null;

  constructor(readonly canvas: HTMLCanvasElement) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFSoftShadowMap;
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.renderer.toneMappingExposure = 1.05;
    this.ground = new THREE.Mesh(new THREE.CircleGeometry(1, 64), new THREE.ShadowMaterial({ opacity: 0.22 }));
    this.paper = new THREE.Mesh(
      new THREE.CircleGeometry(1, 96),
      new THREE.MeshBasicMaterial({ transparent: true, depthWrite: false, alphaMap: softDisc() }),
    );
    this.plane = new THREE.Mesh(
      new THREE.PlaneGeometry(1, 1),
      new THREE.MeshBasicMaterial({ color: 0x3a6ea5, transparent: true, opacity: 0.07, side: THREE.DoubleSide, depthWrite: false }),
    );
    this.plane.visible = false;
    for (const disc of [this.ground, this.paper]) {
      disc.rotation.x = -Math.PI / 2;
      disc.receiveShadow = true;
    }
    this.paper.renderOrder = -1;
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.radius = 6;
    this.sun.shadow.normalBias = 0.02;
    this.scene.add(this.sky, this.sun, this.sun.target, this.paper, this.ground, this.plane);
    this.rig.onChange = () => this.invalidate();
    this.setLight(0.6, 0.9);
    this.fitScene();
  }

  setTheme(theme: StageTheme): void {
    this.paper.material.color.set(theme.ground);
    this.invalidate();
  }

  /** The light's heading and elevation, radians, about the scene's middle. */
  setLight(heading: number, elevation: number): void {
    const level = Math.cos(elevation);
    this.sun.userData['direction'] = new THREE.Vector3(Math.sin(heading) * level, Math.sin(elevation), Math.cos(heading) * level);
    this.fitScene();
  }

  resize(width: number, height: number, ratio: number): void {
    this.renderer.setPixelRatio(ratio);
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
    if (frames.length > 0) this.invalidate();
  }

  /** The box around all joints, in the scene. */
  bounds(actor?: number): THREE.Box3 {
    const box = new THREE.Box3();
    const point = new THREE.Vector3();
    for (const [id, view] of this.characters) {
      if (actor !== undefined && id !== actor) continue;
      view.info.joints.forEach((joint, i) => {
        if (!joint.helper && 3 * i < view.joints.length) box.expandByPoint(view.joint(i, point));
      });
    }
    if (box.isEmpty()) box.set(new THREE.Vector3(-0.5, 0, -0.5), new THREE.Vector3(0.5, 1.8, 0.5));
    return box;
  }

  frame(actor?: number): void {
    const box = this.bounds(actor);
    const size = box.getSize(new THREE.Vector3());
    const aspect = this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight);
    const width = Math.hypot(size.x, size.z);
    this.rig.set({ target: box.getCenter(new THREE.Vector3()), height: 1.32 * Math.max(size.y, width / aspect, 1e-3) });
  }

  showPlane(normal: THREE.Vector3 | null): void {
    this.plane.visible = normal !== null;
    if (normal) {
      const box = this.bounds();
      const centre = box.getCenter(new THREE.Vector3());
      this.plane.position.copy(centre);
      this.plane.lookAt(centre.clone().add(normal));
      this.plane.scale.setScalar(1.4 * box.getSize(new THREE.Vector3()).length());
    }
    this.invalidate();
  }

  setMini(canvas: HTMLCanvasElement | null): void {
    this.mini = canvas;
    this.invalidate();
  }

  invalidate(): void {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  /** A picture of the table as it stands: a size of its own, with or without the ground. */
  snapshot(width: number, height: number, transparent: boolean, paper: string): HTMLCanvasElement {
    const size = this.renderer.getSize(new THREE.Vector2());
    const ratio = this.renderer.getPixelRatio();
    this.renderer.setPixelRatio(1);
    this.renderer.setSize(width, height, false);
    this.rig.resize(width, height);
    const hidden = [this.paper, this.ground].filter((disc) => transparent && disc.visible);
    for (const disc of hidden) disc.visible = false;
    this.renderer.render(this.scene, this.rig.camera);
    for (const disc of hidden) disc.visible = true;
    const copy = document.createElement('canvas');
    copy.width = width;
    copy.height = height;
    const context = copy.getContext('2d')!;
    if (!transparent) {
      context.fillStyle = paper;
      context.fillRect(0, 0, width, height);
    }
    context.drawImage(this.canvas, 0, 0);
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(size.x, size.y, false);
    this.rig.resize(size.x, size.y);
    this.draw();
    return copy;
  }

  private draw(): void {
    const started = performance.now();
    if (this.mini) this.drawMini(this.mini);
    this.renderer.render(this.scene, this.rig.camera);
    this.stats.frames += 1;
    this.stats.drawCalls = this.renderer.info.render.calls;
    this.stats.drawMs = performance.now() - started;
    this.onDrawn();
  }

  /** The same scene from a quarter turn to the side: it shows what a line cannot, the depth. */
  private drawMini(target: HTMLCanvasElement): void {
    const size = this.renderer.getSize(new THREE.Vector2());
    const width = Math.min(target.width, size.x);
    const height = Math.min(target.height, size.y);
    const box = this.bounds();
    const extent = box.getSize(new THREE.Vector3()).length() * 0.62;
    const camera = new THREE.OrthographicCamera((-extent * width) / height, (extent * width) / height, extent, -extent, -50 * extent, 50 * extent);
    const side = this.rig.state.heading + Math.PI / 2;
    const centre = box.getCenter(new THREE.Vector3());
    camera.position.copy(centre).add(new THREE.Vector3(Math.sin(side), 0, Math.cos(side)).multiplyScalar(extent));
    camera.lookAt(centre);
    const ratio = this.renderer.getPixelRatio();
    this.renderer.setViewport(0, 0, width / ratio, height / ratio);
    this.renderer.setScissor(0, 0, width / ratio, height / ratio);
    this.renderer.setScissorTest(true);
    this.renderer.render(this.scene, camera);
    this.renderer.setScissorTest(false);
    this.renderer.setViewport(0, 0, size.x, size.y);
    const context = target.getContext('2d')!;
    context.clearRect(0, 0, target.width, target.height);
    context.drawImage(this.canvas, 0, this.canvas.height - height, width, height, 0, 0, target.width, target.height);
  }

  /** Ground, light and shadow sized to what stands on the table. */
  private fitScene(): void {
    const box = this.bounds();
    const size = box.getSize(new THREE.Vector3()).length();
    const centre = box.getCenter(new THREE.Vector3());
    const ground = box.min.y > 0 && box.min.y < 0.2 * size ? 0 : box.min.y;
    this.paper.position.set(centre.x, ground - 1e-4 * size, centre.z);
    this.ground.position.set(centre.x, ground, centre.z);
    this.paper.scale.setScalar(1.6 * size);
    this.ground.scale.setScalar(4 * size);
    const direction = this.sun.userData['direction'] as THREE.Vector3;
    this.sun.target.position.copy(centre);
    this.sun.position.copy(centre).addScaledVector(direction, 2 * size);
    const shadow = this.sun.shadow.camera;
    Object.assign(shadow, { left: -size, right: size, top: size, bottom: -size, near: 0.1 * size, far: 5 * size });
    shadow.updateProjectionMatrix();
    this.sun.shadow.normalBias = 0.006 * size;
    this.invalidate();
  }
}

/** White in the middle, fading to nothing: the sheet of paper ends softly. */
function softDisc(): THREE.Texture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 256;
  const context = canvas.getContext('2d')!;
  const fade = context.createRadialGradient(128, 128, 20, 128, 128, 128);
  fade.addColorStop(0, '#fff');
  fade.addColorStop(0.6, '#888');
  fade.addColorStop(1, '#000');
  context.fillStyle = fade;
  context.fillRect(0, 0, 256, 256);
  return new THREE.CanvasTexture(canvas);
}
