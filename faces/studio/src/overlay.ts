// SPDX-License-Identifier: MIT
// What lies on the glass over the picture: the lines on the table and the line under the pen, bones and joints to grab.
import * as THREE from 'three';
import type { ActorInfo, CameraSpec, Sample, StrokeInfo, Vec3 } from './engine/protocol';
import { dark, showSkeleton } from './model/prefs';
import type { Table } from './model/table';
import { AXES, type Axis, type ToolName } from './tools/tool';
import type { CameraRig } from './view/camera_rig';
import { type InkLayer, type InkLine, type Marker, toPoints } from './view/ink';
import type { Stage } from './view/stage';

const INK = { light: '#8c2f1b', dark: '#ff9d7a' };
const INK_QUIET = { light: 'rgba(90,60,45,0.45)', dark: 'rgba(255,220,200,0.4)' };
const SIDE = { left: '#c2572b', right: '#2f6f9f', middle: '#7a6a58' };
const PICKED = '#b3261e';
const AXIS: Record<Axis, string> = { x: '#c8372d', y: '#3f8f3a', z: '#2f6fc4' };
const ENDS = /Hand$|Foot$|Toes$|^head$/;

type Bone = [Marker, Marker, string];

/** The line under the pen; `editing` is the line that it is put in place of. */
export interface LiveLine {
  samples: Sample[];
  editing: number | null;
}

export class Overlay {
  constructor(
    private readonly table: Table,
    private readonly stage: Stage,
    private readonly ink: InkLayer,
    private readonly tool: () => ToolName,
    private readonly axis: () => Axis | null,
  ) {}

  /** Lines, and with `helpers` bones and joints; `live` is the line under the pen. */
  draw(live: LiveLine | null, hovered: number | null, { helpers = true, ink = this.ink } = {}): void {
    const theme = dark.value ? 'dark' : 'light';
    const lines: InkLine[] = [];
    for (const stroke of this.table.state.value.strokes) {
      if (stroke.hidden || stroke.id === live?.editing) continue;
      const selected = stroke.id === this.table.stroke.value && helpers;
      if (isInView(stroke, this.stage.rig)) {
        const newest = stroke === newestStroke(this.table);
        lines.push({ points: toPoints(stroke.samples), color: newest ? INK[theme] : INK_QUIET[theme], width: 4, handles: selected && this.tool() !== 'drag' });
      } else {
        lines.push({ points: this.anchored(stroke), color: INK_QUIET[theme], width: 2.5, dashed: true });
      }
    }
    if (helpers) lines.push(...this.heldAxis());
    if (live) lines.push({ points: toPoints(live.samples), color: INK[theme], width: 4.5, handles: live.editing !== null });
    const [bones, markers]: [Bone[], Marker[]] = helpers ? this.helpers(live !== null, hovered) : [[], []];
    ink.draw(lines, bones, markers);
  }

  /** A line seen from elsewhere: its points in the plane through the character that faced the pen, projected anew. */
  private anchored(stroke: StrokeInfo): InkLine['points'] {
    const camera = cameraOf(stroke.camera);
    const view = this.stage.characters.get(stroke.actor);
    const joint = stroke.line.joints[Math.floor(stroke.line.joints.length / 2)] ?? 0;
    const depth = (view?.joint(joint) ?? new THREE.Vector3()).project(camera).z;
    return stroke.samples.map(([x, y, , pressure]) => {
      const ndc = new THREE.Vector3((2 * x) / stroke.camera.width - 1, 1 - (2 * y) / stroke.camera.height_px, depth);
      const at = this.stage.rig.project(ndc.unproject(camera));
      return { x: at.x, y: at.y, pressure };
    });
  }

  /** The axis that rotations are held to, through the joint in hand. */
  private heldAxis(): InkLine[] {
    const axis = this.axis();
    const view = this.stage.characters.get(this.table.actor.value);
    const joint = this.table.joint.value;
    if (!axis || !view || joint === null) return [];
    const half = new THREE.Vector3(...AXES[axis]).multiplyScalar(0.35 * view.info.extent);
    const at = view.joint(joint);
    const points = [at.clone().sub(half), at.clone().add(half)].map((p) => ({ ...toXY(this.stage.rig.project(p)), pressure: 0.5 }));
    return [{ points, color: AXIS[axis], width: 2.5 }];
  }

  private helpers(drawing: boolean, hovered: number | null): [Bone[], Marker[]] {
    const view = this.stage.characters.get(this.table.actor.value);
    if (!view) return [[], []];
    const tool = this.tool();
    const chosen = new Set(this.table.picked.value);
    const inSegment = new Set(this.table.segments.value.flatMap((segment) => segment.slice(1)));
    const line = new Set(this.table.solved.value?.line.joints ?? []);
    const pins = new Set(view.info.pins.map((pin) => pin.joint));
    const bones: Bone[] = [];
    const markers: Marker[] = [];
    view.info.joints.forEach((joint, i) => {
      if (joint.helper) return;
      const { x, y } = this.stage.rig.project(view.joint(i));
      const color = SIDE[sideOf(joint.bone || joint.name)];
      const at: Marker = { x, y, color, radius: 4 };
      const boneColor = inSegment.has(i) ? PICKED : color;
      const parent = view.info.joints[joint.parent];
      if (parent && !parent.helper && (showSkeleton.value || inSegment.has(i))) {
        const from = this.stage.rig.project(view.joint(joint.parent));
        bones.push([{ x: from.x, y: from.y, color, radius: 3 }, at, boneColor]);
      }
      if (chosen.has(i)) markers.push({ ...at, radius: 7, color: PICKED });
      else if (pins.has(i)) markers.push({ ...at, radius: 7, color: '#2e7d4f' });
      else if (i === hovered || i === this.table.joint.value) markers.push({ ...at, radius: 8, hollow: true });
      else if (tool === 'drag' && isEnd(view.info, i)) markers.push({ ...at, radius: 6, hollow: true });
      else if (tool === 'rotate' || tool === 'select') markers.push({ ...at, radius: 3.5, hollow: true });
      else if (drawing && line.has(i)) markers.push({ ...at, radius: 3.5 });
    });
    return [bones, markers];
  }
}

const toXY = ({ x, y }: THREE.Vector2) => ({ x, y });

/** The line that is selected, or else the newest of the character in hand. */
export function newestStroke(table: Table): StrokeInfo | null {
  const own = table.state.value.strokes.filter((stroke) => stroke.actor === table.actor.value);
  return table.currentStroke.value ?? own.at(-1) ?? null;
}

/** A line is shown as drawn only from where it was drawn; from elsewhere it is shown in its plane, quietly. */
export function isInView(stroke: StrokeInfo, rig: CameraRig): boolean {
  const now = rig.toSpec();
  const far = (a: Vec3, b: Vec3) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  const scale = 1e-3 * far(now.position, now.target);
  const same = now.projection === stroke.camera.projection && far(now.position, stroke.camera.position) < scale;
  return same && far(now.target, stroke.camera.target) < scale && now.height_px === stroke.camera.height_px && now.width === stroke.camera.width;
}

export function isEnd(info: ActorInfo, joint: number): boolean {
  const bone = info.joints[joint]!.bone;
  if (info.joints.some((j) => /Hand$|Foot$/.test(j.bone))) return ENDS.test(bone);
  return !info.joints.some((j) => j.parent === joint);
}

function sideOf(name: string): 'left' | 'right' | 'middle' {
  return /^left|left_|_l$|\.l$/i.test(name) ? 'left' : /^right|right_|_r$|\.r$/i.test(name) ? 'right' : 'middle';
}

function cameraOf(spec: CameraSpec): THREE.Camera {
  const aspect = spec.width / spec.height_px;
  const half = spec.projection === 'orthographic' ? spec.height / 2 : 0;
  const far = 1e3 * Math.hypot(...(spec.position.map((p, i) => p - spec.target[i]!) as Vec3));
  const camera =
    spec.projection === 'orthographic'
      ? new THREE.OrthographicCamera(-half * aspect, half * aspect, half, -half, -far, far)
      : new THREE.PerspectiveCamera(spec.fov_degrees, aspect, far * 1e-6, far);
  camera.position.set(...spec.position);
  camera.up.set(...spec.up);
  camera.lookAt(...spec.target);
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
  return camera;
}
