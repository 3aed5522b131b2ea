// SPDX-License-Identifier: MIT
// Draws the line of action. On a selected line it instead drags one of its points, or redraws the part drawn over.
//   draw.idle -> draw.drawing -> draw.idle
//             -> draw.point   -> draw.idle
//             -> draw.part    -> draw.idle
import type { CameraSpec, Command, Sample, StrokeInfo } from '../engine/protocol';
import { dragPoint, handleIndices } from '../view/ink';
import type { PointerSample } from './gestures';
import type { Tool } from './tool';

export interface DrawContext {
  /** The selected line, if it is drawn in the present view. */
  editable(): StrokeInfo | null;
  camera(): CameraSpec;
  /** Takes another character in hand, if the line starts on it and far from the one that is. */
  aim(x: number, y: number): void;
  /** Tells why no line can be drawn now, if none can. */
  refuses(): boolean;
  /** The command that draws these samples as they are meant now. */
  drawCommand(samples: Sample[], camera: CameraSpec): Command;
  preview(command: Command): void;
  commit(command: Command): void;
  cancelPreview(): void;
  showInk(samples: Sample[] | null, editing: number | null): void;
}

type State =
  | { path: 'idle' }
  | { path: 'drawing'; camera: CameraSpec; samples: Sample[]; start: number }
  | { path: 'point'; stroke: StrokeInfo; index: number; x: number; y: number; now: Sample[] }
  | { path: 'part'; stroke: StrokeInfo; drawn: Sample[]; start: number };

const GRAB_PX = 16;
const SHORTEST_PX = 6;

export class DrawTool implements Tool {
  private state: State = { path: 'idle' };

  constructor(private readonly context: DrawContext) {}

  get path(): string {
    return `draw.${this.state.path}`;
  }

  down(p: PointerSample): void {
    const stroke = this.context.editable();
    const handle = stroke ? grabbedHandle(stroke.samples, p) : -1;
    if (stroke && handle >= 0) {
      this.state = { path: 'point', stroke, index: handle, x: p.x, y: p.y, now: stroke.samples };
    } else if (stroke && distanceTo(stroke.samples, p).distance < GRAB_PX) {
      this.state = { path: 'part', stroke, drawn: [toSample(p, p.time)], start: p.time };
    } else if (!this.context.refuses()) {
      this.context.aim(p.x, p.y);
      const camera = this.context.camera();
      this.state = { path: 'drawing', camera, samples: [toSample(p, p.time)], start: p.time };
      this.context.showInk(this.state.samples, null);
    }
  }

  move(points: PointerSample[]): void {
    const state = this.state;
    const last = points.at(-1);
    if (!last) return;
    if (state.path === 'drawing') {
      for (const p of points) addSample(state.samples, toSample(p, state.start));
      this.context.showInk(state.samples, null);
      if (lengthOf(state.samples) > SHORTEST_PX) this.context.preview(this.context.drawCommand(state.samples, state.camera));
    } else if (state.path === 'point') {
      state.now = dragPoint(state.stroke.samples, state.index, last.x - state.x, last.y - state.y);
      this.context.showInk(state.now, state.stroke.id);
      this.context.preview({ name: 'redraw', stroke: state.stroke.id, samples: state.now });
    } else if (state.path === 'part') {
      for (const p of points) addSample(state.drawn, toSample(p, state.start));
      const merged = redrawPart(state.stroke.samples, state.drawn);
      this.context.showInk(merged, state.stroke.id);
      this.context.preview({ name: 'redraw', stroke: state.stroke.id, samples: merged });
    }
  }

  up(p: PointerSample): void {
    const state = this.state;
    this.state = { path: 'idle' };
    this.context.showInk(null, null);
    if (state.path === 'drawing') {
      addSample(state.samples, toSample(p, state.start));
      // A dot is a slip of the hand, not a line.
      if (lengthOf(state.samples) > SHORTEST_PX) this.context.commit(this.context.drawCommand(state.samples, state.camera));
      else this.context.cancelPreview();
    } else if (state.path === 'point' && state.now !== state.stroke.samples) {
      this.context.commit({ name: 'redraw', stroke: state.stroke.id, samples: state.now });
    } else if (state.path === 'part' && lengthOf(state.drawn) > SHORTEST_PX) {
      this.context.commit({ name: 'redraw', stroke: state.stroke.id, samples: redrawPart(state.stroke.samples, state.drawn) });
    }
  }

  cancel(): void {
    if (this.state.path === 'idle') return;
    this.state = { path: 'idle' };
    this.context.showInk(null, null);
    this.context.cancelPreview();
  }
}

function toSample(p: PointerSample, start: number): Sample {
  return [p.x, p.y, (p.time - start) / 1000, p.pressure];
}

/** Samples that stand still say nothing and would only weigh on the solver. */
function addSample(samples: Sample[], sample: Sample): void {
  const last = samples.at(-1)!;
  if (Math.hypot(sample[0] - last[0], sample[1] - last[1]) >= 0.75) samples.push(sample);
}

export function lengthOf(samples: Sample[]): number {
  let length = 0;
  for (let i = 1; i < samples.length; ++i) {
    length += Math.hypot(samples[i]![0] - samples[i - 1]![0], samples[i]![1] - samples[i - 1]![1]);
  }
  return length;
}

export function distanceTo(samples: Sample[], p: { x: number; y: number }): { index: number; distance: number } {
  let best = { index: -1, distance: Infinity };
  samples.forEach(([x, y], index) => {
    const distance = Math.hypot(x - p.x, y - p.y);
    if (distance < best.distance) best = { index, distance };
  });
  return best;
}

function grabbedHandle(samples: Sample[], p: { x: number; y: number }): number {
  return handleIndices(samples.length).find((i) => Math.hypot(samples[i]![0] - p.x, samples[i]![1] - p.y) < GRAB_PX) ?? -1;
}

/** The old line with what was drawn in place of the part between the ends of what was drawn. */
export function redrawPart(old: Sample[], drawn: Sample[]): Sample[] {
  const first = drawn[0]!;
  const last = drawn.at(-1)!;
  const a = distanceTo(old, { x: first[0], y: first[1] }).index;
  const end = distanceTo(old, { x: last[0], y: last[1] });
  const leaves = end.distance > 3 * GRAB_PX; // it runs off: from there on the line is the new one
  const forward = end.index >= a;
  const middle = forward || leaves ? drawn : [...drawn].reverse();
  const [from, to] = forward || leaves ? [a, end.index] : [end.index, a];
  const merged = leaves ? [...old.slice(0, from), ...middle] : [...old.slice(0, from), ...middle, ...old.slice(to + 1)];
  return merged.map(([x, y, , pressure], i) => [x, y, i / 100, pressure]);
}
