// SPDX-License-Identifier: MIT
// What the engine answers to each request of the page, every failure in words. Runs in the worker, and in tests.
import type { Table } from '../../wasm/croquis.mjs';
import type { Change, PartGeometry, Reply, Request } from './messages';
import type { Command, EngineFailure, PoseFrame, Solved, TableState } from './protocol';

class EngineError extends Error {
  constructor(readonly failure: EngineFailure) {
    super(failure.message);
  }
}

/** Every bound function answers JSON: its result, or { error: { code, message } }. */
function parse<T>(json: string): T {
  const answer = JSON.parse(json) as T & { error?: EngineFailure };
  if (answer.error) throw new EngineError(answer.error);
  return answer;
}

/** The engine, and how the page has its poses: for blending by matrices, or by dual quaternions. */
export interface Seat {
  table: Table;
  dual: boolean;
}

function frames({ table, dual }: Seat, actors: number[]): PoseFrame[] {
  return actors.map((actor) => ({
    actor,
    palette: table.palette(actor, dual).slice(),
    joints: table.jointPositions(actor).slice(),
  }));
}

function change(seat: Seat, json: string, started: number): Change {
  const answer = parse<{ state?: TableState; moved: number[]; solved?: Solved; solve_ms?: number; notice?: string }>(json);
  return {
    ...(answer.state ? { state: answer.state } : {}),
    ...(answer.notice ? { notice: answer.notice } : {}),
    frames: frames(seat, answer.moved),
    solved: answer.solved ?? null,
    timing: { solve_ms: answer.solve_ms ?? 0, engine_ms: performance.now() - started },
  };
}

function geometry(table: Table, actor: number, part: number): PartGeometry {
  const info = parse<{ influences: number; shapes: { weight: number }[]; has_image: boolean }>(table.partInfo(actor, part));
  const floats = (what: string, shape = -1): Float32Array => (table.buffer(actor, part, what, shape) as Float32Array).slice();
  return {
    positions: floats('positions'),
    normals: floats('normals'),
    uvs: floats('uvs'),
    triangles: (table.buffer(actor, part, 'triangles', -1) as Uint32Array).slice(),
    joint_indices: (table.buffer(actor, part, 'joint_indices', -1) as Uint16Array).slice(),
    weights: floats('weights'),
    influences: info.influences,
    shapes: info.shapes.map((shape, i) => ({
      positions: floats('shape_positions', i),
      normals: floats('shape_normals', i),
      weight: shape.weight,
    })),
    image: info.has_image ? (table.buffer(actor, part, 'image', -1) as Uint8Array).slice() : null,
  };
}

/** What previews would show, one by one; then the project is shown again. */
function poseFrames(seat: Seat, commands: Command[]): (PoseFrame | null)[] {
  const { table } = seat;
  const shown = commands.map((command) => {
    try {
      parse(table.preview(JSON.stringify(command)));
      return frames(seat, [(command as { actor: number }).actor])[0] ?? null;
    } catch {
      return null;
    }
  });
  table.cancelPreview();
  return shown;
}

function answer(seat: Seat, request: Request): unknown {
  const { table } = seat;
  const started = performance.now();
  switch (request.kind) {
    case 'begin':
      return table.begin();
    case 'commit':
      return change(seat, table.execute(JSON.stringify(request.command), request.bytes ?? new Uint8Array()), started);
    case 'preview':
      return change(seat, table.preview(JSON.stringify(request.command)), started);
    case 'cancel':
      return change(seat, table.cancelPreview(), started);
    case 'skinning':
      seat.dual = request.dual;
      return change(seat, table.cancelPreview(), started);
    case 'pose_frames':
      return poseFrames(seat, request.commands);
    case 'undo':
      return change(seat, table.undo(), started);
    case 'redo':
      return change(seat, table.redo(), started);
    case 'restore':
      return change(seat, table.restore(request.bytes), started);
    case 'geometry':
      return geometry(table, request.actor, request.part);
    case 'vertices':
      return table.vertices(request.actor, request.part, seat.dual).slice();
    case 'export': {
      parse(table.prepareExport(request.format, request.actor, JSON.stringify(request.options)));
      return table.exported().slice();
    }
    case 'query':
      return parse(table.query(request.name, JSON.stringify(request.args)));
  }
}

export function replyTo(seat: Seat, id: number, request: Request): Reply {
  try {
    return { id, result: answer(seat, request) };
  } catch (error) {
    return { id, failure: error instanceof EngineError ? error.failure : { code: 'internal', message: String(error) } };
  }
}

/** The buffers of a reply that can be handed over instead of copied. */
export function transfers(value: unknown): Transferable[] {
  if (value instanceof Uint8Array || value instanceof Float32Array) return [value.buffer as ArrayBuffer];
  const result = value as Partial<Change> & Partial<PartGeometry>;
  if (result?.frames) return result.frames.flatMap((f) => [f.palette.buffer as ArrayBuffer, f.joints.buffer as ArrayBuffer]);
  return [];
}
