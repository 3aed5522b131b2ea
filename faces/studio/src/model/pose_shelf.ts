// SPDX-License-Identifier: MIT
// The poses that a person keeps, in this browser, for every table to come; saved and opened as a file.
import { signal } from '@preact/signals';

export interface KeptPose {
  name: string;
  /** The engine's text of a pose. */
  pose: string;
}

const KEY = 'croquis.poses';

function stored(): KeptPose[] {
  try {
    return checked(JSON.parse(localStorage.getItem(KEY) ?? '[]'));
  } catch {
    return [];
  }
}

/** Throws unless it is a list of poses, each with a name and the engine's text. */
function checked(value: unknown): KeptPose[] {
  const isPose = (item: unknown): item is KeptPose => {
    const pose = item as Partial<KeptPose> | null;
    return typeof pose?.name === 'string' && typeof pose.pose === 'string';
  };
  if (!Array.isArray(value) || !value.every(isPose)) throw new Error('it holds no list of poses');
  return value.map(({ name, pose }) => ({ name, pose }));
}

export const keptPoses = signal<KeptPose[]>(typeof localStorage === 'undefined' ? [] : stored());

function store(poses: KeptPose[]): void {
  keptPoses.value = poses;
  localStorage.setItem(KEY, JSON.stringify(poses));
}

/** One of the same name is replaced. */
export function keepPose(kept: KeptPose): void {
  store([...keptPoses.value.filter((pose) => pose.name !== kept.name), kept]);
}

export function forgetPose(name: string): void {
  store(keptPoses.value.filter((pose) => pose.name !== name));
}

export function posesAsFile(): string {
  return JSON.stringify({ croquis_poses: 1, poses: keptPoses.value }, null, 1);
}

/** Adds the poses of such a file and says how many; throws what is wrong with it. */
export function keepAll(text: string): number {
  const file = JSON.parse(text) as { croquis_poses?: number; poses?: unknown } | null;
  if (file?.croquis_poses !== 1) throw new Error('it is no file of kept poses');
  const poses = checked(file.poses);
  const names = new Set(poses.map((pose) => pose.name));
  store([...keptPoses.value.filter((pose) => !names.has(pose.name)), ...poses]);
  return poses.length;
}
