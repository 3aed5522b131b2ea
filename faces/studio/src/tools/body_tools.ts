// SPDX-License-Identifier: MIT
// The tools that take hold of the body itself: drag a hand or foot, rotate a joint, pick joints and lines.
import type { Command, Quat, Vec3 } from '../engine/protocol';
import type { PointerSample } from './gestures';
import type { Tool } from './tool';

export interface BodyContext {
  actor(): number;
  /** The joint nearest to a pixel (of all, or only of hands, feet and ends), if near enough. */
  jointAt(x: number, y: number, endsOnly: boolean): number | null;
  /** Takes another character in hand, if one has a joint there. */
  takeActorAt(x: number, y: number): boolean;
  strokeAt(x: number, y: number): number | null;
  jointPixel(joint: number): { x: number; y: number };
  /** Maps pixels to points of the plane that faces the camera through where the joint is now. */
  planeThrough(joint: number): (x: number, y: number) => Vec3;
  viewAxis(): Vec3;
  /** The axis of the scene that is held, if one is. */
  heldAxis(): Vec3 | null;
  /** A direction as the viewer sees it: to the right, up, and toward him. */
  axisInView(axis: Vec3): { x: number; y: number; toward: number };
  boneAxis(joint: number): Vec3;
  selectJoint(joint: number | null): void;
  selectStroke(stroke: number | null): void;
  togglePicked(joint: number): void;
  hoverJoint(joint: number | null): void;
  preview(command: Command): void;
  commit(command: Command): void;
  cancelPreview(): void;
}

/** A joint there, of the character in hand or else of another, which is then in hand. */
function grab(context: BodyContext, p: PointerSample, endsOnly: boolean): number | null {
  const joint = context.jointAt(p.x, p.y, endsOnly);
  return joint === null && context.takeActorAt(p.x, p.y) ? context.jointAt(p.x, p.y, endsOnly) : joint;
}

function turn(axis: Vec3, angle: number): Quat {
  const s = Math.sin(angle / 2);
  return [axis[0] * s, axis[1] * s, axis[2] * s, Math.cos(angle / 2)];
}

/** drag.idle -> drag.dragging -> drag.idle */
export class DragTool implements Tool {
  private joint: number | null = null;
  private pointAt: (x: number, y: number) => Vec3 = () => [0, 0, 0];
  private last: Command | null = null;

  constructor(private readonly context: BodyContext) {}

  get path(): string {
    return this.joint === null ? 'drag.idle' : 'drag.dragging';
  }

  hover(p: PointerSample): void {
    this.context.hoverJoint(this.context.jointAt(p.x, p.y, true));
  }

  down(p: PointerSample): void {
    this.joint = grab(this.context, p, true);
    this.last = null;
    if (this.joint !== null) this.pointAt = this.context.planeThrough(this.joint);
    this.context.selectJoint(this.joint);
  }

  move(points: PointerSample[]): void {
    const p = points.at(-1);
    if (this.joint === null || !p) return;
    this.last = { name: 'drag', actor: this.context.actor(), joint: this.joint, target: this.pointAt(p.x, p.y) };
    this.context.preview(this.last);
  }

  up(): void {
    if (this.last) this.context.commit(this.last);
    this.joint = this.last = null;
  }

  cancel(): void {
    if (this.last) this.context.cancelPreview();
    this.joint = this.last = null;
  }
}

interface Grab {
  joint: number;
  centre: { x: number; y: number };
  start: PointerSample;
  twist: boolean;
}

const PER_PIXEL = 0.012; // radians

/** rotate.idle -> rotate.turning -> rotate.idle. A joint turns about the line of sight, or about an axis of the scene that
    is held; with Shift it twists about its bone. */
export class RotateTool implements Tool {
  private grabbed: Grab | null = null;
  private at: PointerSample | null = null;
  private last: Command | null = null;

  constructor(private readonly context: BodyContext) {}

  get path(): string {
    return this.grabbed === null ? 'rotate.idle' : 'rotate.turning';
  }

  hover(p: PointerSample): void {
    this.context.hoverJoint(this.context.jointAt(p.x, p.y, false));
  }

  down(p: PointerSample): void {
    const joint = grab(this.context, p, false);
    this.context.selectJoint(joint);
    this.last = this.at = null;
    if (joint !== null) this.grabbed = { joint, centre: this.context.jointPixel(joint), start: p, twist: p.shift };
  }

  move(points: PointerSample[]): void {
    this.at = points.at(-1) ?? this.at;
    this.turned();
  }

  /** The axis was changed, perhaps in the middle of a turn. */
  turned(): void {
    if (!this.grabbed || !this.at) return;
    const { joint, start, twist } = this.grabbed;
    const held = twist ? this.context.boneAxis(joint) : this.context.heldAxis();
    const axis = held ?? this.context.viewAxis();
    const angle = twist ? (this.at.x - start.x) * PER_PIXEL : held ? this.angleAbout(held) : this.angleInView();
    this.last = { name: 'rotate', actor: this.context.actor(), joint, rotation_model: turn(axis, angle) };
    this.context.preview(this.last);
  }

  /** How far the hand went around the joint; from close by, how far it went across. */
  private angleInView(): number {
    const { centre, start } = this.grabbed!;
    const p = this.at!;
    if (Math.hypot(start.x - centre.x, start.y - centre.y) <= 24) return -(p.x - start.x) * PER_PIXEL;
    return Math.atan2(start.y - centre.y, start.x - centre.x) - Math.atan2(p.y - centre.y, p.x - centre.x);
  }

  /** About an axis that points at the viewer (or away) as in the view; about one that lies across, as if the hand rolled
      the side of the joint that it sees. */
  private angleAbout(axis: Vec3): number {
    const seen = this.context.axisInView(axis);
    if (Math.abs(seen.toward) > 0.7) return Math.sign(seen.toward) * this.angleInView();
    const { start } = this.grabbed!;
    const across = Math.hypot(seen.x, seen.y);
    return (((this.at!.x - start.x) * seen.y + (this.at!.y - start.y) * seen.x) / across) * PER_PIXEL;
  }

  up(): void {
    if (this.last) this.context.commit(this.last);
    this.grabbed = this.last = this.at = null;
  }

  cancel(): void {
    if (this.last) this.context.cancelPreview();
    this.grabbed = this.last = this.at = null;
  }
}

/** select.idle: a tap picks a line, or adds a joint to the line picked by hand. */
export class SelectTool implements Tool {
  readonly path = 'select.idle';
  private start: PointerSample | null = null;

  constructor(private readonly context: BodyContext) {}

  hover(p: PointerSample): void {
    this.context.hoverJoint(this.context.jointAt(p.x, p.y, false));
  }

  down(p: PointerSample): void {
    this.start = p;
  }

  move(): void {}

  up(p: PointerSample): void {
    const start = this.start;
    this.start = null;
    if (!start || Math.hypot(p.x - start.x, p.y - start.y) > 12) return;
    const stroke = this.context.strokeAt(p.x, p.y);
    if (stroke !== null) return this.context.selectStroke(stroke);
    if (this.context.jointAt(p.x, p.y, false) === null && this.context.takeActorAt(p.x, p.y)) return; // only that for now
    const joint = this.context.jointAt(p.x, p.y, false);
    this.context.selectJoint(joint);
    if (joint !== null) this.context.togglePicked(joint);
    else this.context.selectStroke(null);
  }

  cancel(): void {
    this.start = null;
  }
}
