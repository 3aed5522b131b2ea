// SPDX-License-Identifier: MIT
// What the page and the engine say to each other. The engine decides; the page shows. Names are the engine's own
// (edit/), so that a journal written by the page reads as the commands of the command line.

export type Vec2 = [number, number];
export type Vec3 = [number, number, number];
/** x, y, z, w. */
export type Quat = [number, number, number, number];

interface CameraPlace {
  position: Vec3;
  target: Vec3;
  up: Vec3;
  width: number;
  height_px: number;
}

/** `height`: of the picture without perspective, scene units. */
export type CameraSpec = CameraPlace &
  ({ projection: 'perspective'; fov_degrees: number } | { projection: 'orthographic'; height: number });

/** One pen sample: x, y in pixels of the stroke's camera, seconds, pressure 0..1. */
export type Sample = [x: number, y: number, time: number, pressure: number];

export type LimitPreset = 'anatomical' | 'dancer' | 'cartoon' | 'none';
export type Method = 'line' | 'rotation' | 'rotation-index' | 'near' | 'curvilinear';

export interface StrokeSettings {
  method: Method;
  /** A standard line's name; 'auto' lets the engine guess; empty where `joints` says it. */
  body_line: string;
  joints: number[];
  plane: 'free' | 'ground';
  root: 'lock' | 'tangent' | 'free';
  direction: 'auto' | 'forward' | 'backward' | 'length';
  move: 'line' | 'body';
  length: 'fit' | 'scale' | 'trim' | 'extend';
  exaggerate: number;
  weight: number;
  alternative: number;
}

/** Switches that hold for the whole table. */
export interface TableSettings {
  limits: LimitPreset;
  floor: boolean;
  balance: boolean;
  root: 'lock' | 'tangent' | 'free';
}

export interface JointInfo {
  name: string;
  parent: number;
  helper: boolean;
  /** The VRM name of the humanoid bone it plays, or ''. */
  bone: string;
}

export interface BodyLineInfo {
  name: string;
  joints: number[];
}

export interface PartInfo {
  name: string;
  vertices: number;
  triangles: number;
  influences: number;
  shapes: string[];
  base_color: [number, number, number, number];
  has_image: boolean;
  double_sided: boolean;
  cut_out: boolean;
  /** First entry of this part in the character's palette. */
  palette_offset: number;
}

export interface ActorInfo {
  id: number;
  name: string;
  format: string;
  joints: JointInfo[];
  parts: PartInfo[];
  body_lines: BodyLineInfo[];
  clips: { name: string; frames: number }[];
  front: Vec3;
  extent: number;
  palette_size: number;
  licence: { title: string; authors: string; name: string; terms: Record<string, string> } | null;
  oddities: string[];
  builtin: string;
  proportions: Record<string, number>;
  pins: { joint: number; position: Vec3; rotation: Quat | null }[];
}

export interface StrokeInfo {
  id: number;
  actor: number;
  camera: CameraSpec;
  samples: Sample[];
  settings: StrokeSettings;
  hidden: boolean;
  /** The line that was solved: its name and joints. */
  line: BodyLineInfo;
}

export interface Alternative {
  label: string;
}

/** All that a screen needs to know of the project; the rest stays in the engine. */
export interface TableState {
  actors: ActorInfo[];
  strokes: StrokeInfo[];
  settings: TableSettings;
  views: { name: string; camera: CameraSpec }[];
  poses: { name: string; actor: number }[];
  undo: string;
  redo: string;
}

/** How an actor stands now: what is uploaded for a picture. */
export interface PoseFrame {
  actor: number;
  /** Five texels per palette entry: three rows of a matrix, the two parts of a dual quaternion. */
  palette: Float32Array;
  /** 3 numbers per joint, model space. */
  joints: Float32Array;
}

export interface Solved {
  status: string;
  line: BodyLineInfo;
  alternatives: Alternative[];
  chosen: number;
  solve_ms: number;
}

/** A change to the project, undoable, journalled as it stands here. */
export type Command =
  | { name: 'add_character'; character: string; proportions?: Record<string, number> }
  | { name: 'open'; file: string }
  | { name: 'remove_actor'; actor: number }
  | { name: 'set_proportions'; actor: number; proportions: Record<string, number> }
  | { name: 'draw'; actor: number; samples: Sample[]; camera: CameraSpec; settings: Partial<StrokeSettings> }
  | { name: 'redraw'; stroke: number; samples: Sample[] }
  | { name: 'set_stroke'; stroke: number; settings: Partial<StrokeSettings>; hidden?: boolean }
  | { name: 'delete_stroke'; stroke: number }
  | { name: 'set_table'; settings: Partial<TableSettings> }
  | { name: 'drag'; actor: number; joint: number; target: Vec3 }
  | { name: 'rotate'; actor: number; joint: number; rotation_model: Quat }
  | { name: 'pin'; actor: number; joint: number; on: boolean; with_rotation: boolean }
  | { name: 'mirror'; actor: number; side: 'both' | 'left' | 'right' }
  | { name: 'reset'; actor: number; joints: number[]; amount: number }
  | { name: 'apply_pose'; actor: number; pose: string; strength: number; flipped: boolean }
  | { name: 'keep_pose'; actor: number; pose_name: string }
  | { name: 'go_to_frame'; actor: number; clip: number; frame: number }
  | { name: 'keep_view'; view_name: string; camera: CameraSpec }
  | { name: 'delete_view'; index: number }
  | { name: 'clear' };

export type ExportFormat = 'croquis' | 'glb' | 'gltf' | 'vrm' | 'bvh' | 'svg' | 'openpose';

export interface EngineFailure {
  code: string;
  message: string;
}
