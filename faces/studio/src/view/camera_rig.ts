// SPDX-License-Identifier: MIT
// The camera that a person moves: orbit about a target, pan, zoom, lens. It also writes itself down as the engine's
// camera, so that a stroke keeps the view it was drawn in.
import * as THREE from 'three';
import type { CameraSpec, Vec3 } from '../engine/protocol';

const FILM_HEIGHT = 24; // mm, of the 35 mm picture that focal lengths are quoted for

export const focalToFov = (mm: number): number => (2 * Math.atan(FILM_HEIGHT / 2 / mm) * 180) / Math.PI;
export const fovToFocal = (degrees: number): number => FILM_HEIGHT / 2 / Math.tan((degrees * Math.PI) / 360);

export interface CameraState {
  target: THREE.Vector3;
  /** Heading about the vertical and elevation, radians; 0, 0 looks at the front of a character that faces +Z. */
  heading: number;
  elevation: number;
  /** Height of the picture at the target, scene units. */
  height: number;
  focal: number;
  orthographic: boolean;
}

/** Pixels at the edges of the picture that are covered. */
export interface Insets {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

const STEEPEST = Math.PI / 2 - 1e-4;

export class CameraRig {
  readonly perspective = new THREE.PerspectiveCamera();
  readonly orthographic = new THREE.OrthographicCamera();
  state: CameraState = {
    target: new THREE.Vector3(0, 0.9, 0),
    heading: 0.32,
    elevation: 0.1,
    height: 2.3,
    focal: 70,
    orthographic: false,
  };
  private width = 1;
  private pixels = 1;
  onChange: () => void = () => {};

  get camera(): THREE.PerspectiveCamera | THREE.OrthographicCamera {
    return this.state.orthographic ? this.orthographic : this.perspective;
  }

  resize(width: number, height: number): void {
    this.width = Math.max(1, width);
    this.pixels = Math.max(1, height);
    this.update();
  }

  set(changes: Partial<CameraState>): void {
    Object.assign(this.state, changes);
    this.state.elevation = Math.min(STEEPEST, Math.max(-STEEPEST, this.state.elevation));
    this.state.height = Math.min(1e6, Math.max(1e-6, this.state.height));
    this.update();
  }

  orbit(dx: number, dy: number): void {
    this.set({ heading: this.state.heading - dx * 0.008, elevation: this.state.elevation + dy * 0.008 });
  }

  pan(dx: number, dy: number): void {
    const perPixel = this.state.height / this.pixels;
    const { x, y } = this.axes();
    this.set({ target: this.state.target.clone().addScaledVector(x, -dx * perPixel).addScaledVector(y, dy * perPixel) });
  }

  zoom(factor: number): void {
    this.set({ height: this.state.height * factor });
  }

  /** Puts a box into the middle of what `insets` leave of the picture. */
  frame(box: THREE.Box3, insets: Insets): void {
    const size = box.getSize(new THREE.Vector3());
    const free = {
      width: Math.max(0.2 * this.width, this.width - insets.left - insets.right),
      height: Math.max(0.2 * this.pixels, this.pixels - insets.top - insets.bottom),
    };
    const { heading, elevation } = this.state;
    const across = Math.abs(Math.cos(heading)) * size.x + Math.abs(Math.sin(heading)) * size.z;
    const deep = Math.abs(Math.sin(heading)) * size.x + Math.abs(Math.cos(heading)) * size.z;
    const tall = Math.abs(Math.cos(elevation)) * size.y + Math.abs(Math.sin(elevation)) * deep;
    const perPixel = 1.12 * Math.max(tall / free.height, across / free.width, 1e-9);
    const { x, y } = this.axes();
    const target = box
      .getCenter(new THREE.Vector3())
      .addScaledVector(x, (-(insets.left - insets.right) / 2) * perPixel)
      .addScaledVector(y, ((insets.top - insets.bottom) / 2) * perPixel);
    this.set({ target, height: perPixel * this.pixels });
  }

  /** Direction from the target to the camera. */
  private back(): THREE.Vector3 {
    const { heading, elevation } = this.state;
    const level = Math.cos(elevation);
    return new THREE.Vector3(Math.sin(heading) * level, Math.sin(elevation), Math.cos(heading) * level);
  }

  private axes(): { x: THREE.Vector3; y: THREE.Vector3; z: THREE.Vector3 } {
    const z = this.back();
    const x = new THREE.Vector3(Math.cos(this.state.heading), 0, -Math.sin(this.state.heading));
    return { x, y: z.clone().cross(x), z };
  }

  private distance(): number {
    if (this.state.orthographic) return this.state.height * 6;
    return this.state.height / 2 / Math.tan((focalToFov(this.state.focal) * Math.PI) / 360);
  }

  private update(): void {
    const { target, height, orthographic, focal } = this.state;
    const distance = this.distance();
    const camera = this.camera;
    const axes = this.axes();
    camera.position.copy(target).addScaledVector(axes.z, distance);
    camera.up.copy(axes.y);
    camera.lookAt(target);
    camera.near = Math.max(distance / 400, distance - height * 40);
    camera.far = distance + height * 40;
    const aspect = this.width / this.pixels;
    if (orthographic) {
      Object.assign(this.orthographic, { top: height / 2, bottom: -height / 2 });
      Object.assign(this.orthographic, { right: (height * aspect) / 2, left: (-height * aspect) / 2 });
    } else {
      Object.assign(this.perspective, { fov: focalToFov(focal), aspect });
    }
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    this.onChange();
  }

  toSpec(): CameraSpec {
    const { target, height, orthographic, focal } = this.state;
    const axes = this.axes();
    return {
      ...(orthographic ? { projection: 'orthographic', height } : { projection: 'perspective', fov_degrees: focalToFov(focal) }),
      position: this.camera.position.toArray() as Vec3,
      target: target.toArray() as Vec3,
      up: axes.y.toArray() as Vec3,
      width: Math.round(this.width),
      height_px: Math.round(this.pixels),
    };
  }

  /** Back to the view of a stroke or a saved view. */
  fromSpec(spec: CameraSpec): void {
    const position = new THREE.Vector3(...spec.position);
    const target = new THREE.Vector3(...spec.target);
    const back = position.clone().sub(target);
    const distance = back.length();
    back.normalize();
    const vertical = Math.abs(back.y) > 1 - 1e-9;
    const up = new THREE.Vector3(...spec.up);
    const heading = vertical ? Math.atan2(-up.x * Math.sign(back.y), -up.z * Math.sign(back.y)) : Math.atan2(back.x, back.z);
    const lens =
      spec.projection === 'orthographic'
        ? { orthographic: true, height: spec.height }
        : { orthographic: false, height: 2 * distance * Math.tan((spec.fov_degrees * Math.PI) / 360), focal: fovToFocal(spec.fov_degrees) };
    this.set({ target, heading, elevation: Math.asin(Math.min(1, Math.max(-1, back.y))), ...lens });
  }

  /** Screen pixels (from the canvas's top-left corner) of a point. */
  project(point: THREE.Vector3): THREE.Vector2 {
    const ndc = point.clone().project(this.camera);
    return new THREE.Vector2(((ndc.x + 1) / 2) * this.width, ((1 - ndc.y) / 2) * this.pixels);
  }

  /** The point under a pixel on the plane through `through` that faces the camera. */
  unproject(x: number, y: number, through: THREE.Vector3): THREE.Vector3 {
    const depth = through.clone().project(this.camera).z;
    return new THREE.Vector3((x / this.width) * 2 - 1, 1 - (y / this.pixels) * 2, depth).unproject(this.camera);
  }
}
