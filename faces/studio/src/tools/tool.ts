// SPDX-License-Identifier: MIT
// A tool is a small state machine. Each move is computed from what was there when the pointer came down, so that
// Escape is always right and two hundred moves are one undo step.
import type { PointerSample } from './gestures';

export interface Tool {
  /** The active state as text, such as 'draw.drawing'. */
  readonly path: string;
  down(sample: PointerSample): void;
  move(samples: PointerSample[]): void;
  up(sample: PointerSample): void;
  cancel(): void;
  hover?(sample: PointerSample): void;
}

export type ToolName = 'draw' | 'drag' | 'rotate' | 'select';

/** An axis of the scene that rotations are held to. */
export type Axis = 'x' | 'y' | 'z';
export const AXES: Record<Axis, [number, number, number]> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
