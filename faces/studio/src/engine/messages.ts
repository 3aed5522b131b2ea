// SPDX-License-Identifier: MIT
// The wire between the page and its worker: one request, one reply, numbered.
import type { Command, EngineFailure, ExportFormat, PoseFrame, Solved, TableState } from './protocol';

export interface PartGeometry {
  positions: Float32Array;
  normals: Float32Array;
  uvs: Float32Array;
  triangles: Uint32Array;
  /** `influences` entries per vertex: palette index, weight. */
  joint_indices: Uint16Array;
  weights: Float32Array;
  influences: number;
  shapes: { positions: Float32Array; normals: Float32Array; weight: number }[];
  image: Uint8Array | null;
}

export type Request =
  | { kind: 'begin' }
  | { kind: 'commit'; command: Command; bytes?: Uint8Array }
  | { kind: 'preview'; command: Command }
  | { kind: 'cancel' }
  | { kind: 'skinning'; dual: boolean }
  | { kind: 'pose_frames'; commands: Command[] }
  | { kind: 'undo' }
  | { kind: 'redo' }
  | { kind: 'geometry'; actor: number; part: number }
  | { kind: 'vertices'; actor: number; part: number }
  | { kind: 'export'; format: ExportFormat; actor: number; options: Record<string, unknown> }
  | { kind: 'query'; name: string; args: Record<string, unknown> }
  | { kind: 'restore'; bytes: Uint8Array };

/** What every change answers: the project as a screen needs it, and the poses that changed. */
export interface Change {
  /** Absent after a preview: the project has not changed. */
  state?: TableState;
  frames: PoseFrame[];
  solved: Solved | null;
  /** What could not be done in full. */
  notice?: string;
  timing: { solve_ms: number; engine_ms: number };
}

export interface Reply {
  id: number;
  result?: unknown;
  failure?: EngineFailure;
}
