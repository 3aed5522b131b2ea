// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import type { CameraSpec, Command, PoseFrame, Sample } from '../src/engine/protocol';
import { MemoryJournal, stepsStayAbove, type Entry } from '../src/model/journal';
import { Table } from '../src/model/table';
import { startLocalEngine } from './local_engine';

/** Mulberry32: the same numbers for the same seed, everywhere. */
function seeded(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

const camera: CameraSpec = {
  projection: 'perspective', fov_degrees: 20, position: [0, 0.9, 6.5], target: [0, 0.9, 0], up: [0, 1, 0], width: 800, height_px: 600,
};

function curve(random: () => number): Sample[] {
  const [x, lean, bow] = [380 + 40 * random(), 120 * random() - 60, 160 * random() - 80];
  return Array.from({ length: 20 }, (_, i) => {
    const t = i / 19;
    return [x + lean * t + bow * t * (1 - t), 500 - 400 * t, i / 60, 0.3 + 0.5 * t] as Sample;
  });
}

/** A command that can be made now. */
function anyCommand(table: Table, random: () => number): Command {
  const { actors, strokes } = table.state.value;
  const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)]!;
  const actor = pick(actors);
  const joint = Math.floor(random() * actor.joints.length);
  const stroke = strokes.length > 0 ? pick(strokes).id : null;
  const kinds: (() => Command)[] = [
    () => ({ name: 'draw', actor: actor.id, samples: curve(random), camera, settings: {} }),
    () => ({ name: 'rotate', actor: actor.id, joint, rotation_model: [0, 0.2 * random(), 0.1, 0.97] }),
    () => ({ name: 'mirror', actor: actor.id, side: pick(['both', 'left', 'right'] as const) }),
    () => ({ name: 'reset', actor: actor.id, joints: [], amount: random() }),
    () => ({ name: 'pin', actor: actor.id, joint, on: random() < 0.5, with_rotation: random() < 0.5 }),
    () => ({ name: 'set_table', settings: { floor: random() < 0.5, limits: pick(['anatomical', 'dancer', 'cartoon', 'none'] as const) } }),
    () => ({ name: 'keep_pose', actor: actor.id, pose_name: `pose ${Math.floor(5 * random())}` }),
    () => ({ name: 'keep_view', view_name: `view ${Math.floor(3 * random())}`, camera }),
    () => ({ name: 'drag', actor: actor.id, joint, target: [random() - 0.5, 1.6 * random(), random() - 0.5] }),
  ];
  if (stroke !== null) {
    kinds.push(
      () => ({ name: 'redraw', stroke, samples: curve(random) }),
      () => ({ name: 'set_stroke', stroke, settings: {}, hidden: random() < 0.5 }),
      () => ({ name: 'set_stroke', stroke, settings: { exaggerate: 2 * random() } }),
      () => ({ name: 'delete_stroke', stroke }),
    );
  }
  if (actors.length < 3) kinds.push(() => ({ name: 'add_character', character: pick(['mannequin', 'cat', 'snake', 'tree']) }));
  if (actors.length > 1) kinds.push(() => ({ name: 'remove_actor', actor: actor.id }));
  return pick(kinds)();
}

/** Everything a screen shows, as text. */
async function look(table: Table): Promise<string> {
  const frames: PoseFrame[] = (await table.engine.cancelPreview()).frames;
  const { undo: _undo, redo: _redo, actors, ...state } = table.state.value;
  const bodies = actors.map(({ format: _format, ...actor }) => actor); // one out of a project has a file
  return JSON.stringify([bodies, state, frames.map((frame) => [frame.actor, ...frame.joints])]);
}

describe('the table with the real engine', () => {
  it('two hundred random commands are undone and redone one by one, and a journal plays them again', async () => {
    const random = seeded(20);
    const journal = new MemoryJournal();
    const table = new Table(await startLocalEngine(), journal);
    await table.run({ name: 'add_character', character: 'mannequin' });
    const looks = [await look(table)];
    let refused = 0;
    while (looks.length <= 200) {
      const change = await table.run(anyCommand(table, random));
      if (change) looks.push(await look(table));
      else expect(++refused, 'most commands can be made').toBeLessThan(60);
      if (!change) expect(await look(table), 'a refused command changes nothing').toBe(looks.at(-1));
    }
    for (let i = looks.length - 2; i >= 0; --i) {
      await table.undo();
      expect(await look(table)).toBe(looks[i]);
    }
    for (let i = 1; i < looks.length; ++i) {
      await table.redo();
      expect(await look(table)).toBe(looks[i]);
    }
    await table.undo();
    await table.undo();

    const later = new Table(await startLocalEngine(), journal);
    await later.replay();
    expect(await look(later)).toBe(looks.at(-3));
    await later.redo();
    expect(await look(later)).toBe(looks.at(-2));
  });

  it('keys pressed before the engine has answered lose nothing, and are journalled in their order', async () => {
    const journal = new MemoryJournal();
    const table = new Table(await startLocalEngine(), journal);
    await table.run({ name: 'add_character', character: 'cat' });
    const actor = table.state.value.actors[0]!.id;
    await Promise.all([
      table.run({ name: 'set_table', settings: { floor: false } }),
      table.undo(),
      table.redo(),
      table.undo(),
      table.run({ name: 'reset', actor, joints: [], amount: 1 }),
      table.redo(),
    ]);
    expect(table.busy.value).toBe(0);
    expect(table.state.value.undo).toBe('reset');
    expect((await journal.entries(0)).map((entry) => entry.kind)).toEqual(['commit', 'commit', 'undo', 'redo', 'undo', 'commit']);
    const later = new Table(await startLocalEngine(), journal);
    await later.replay();
    expect(await look(later)).toBe(await look(table));
  });

  it('a command that cannot be done is told in words, and is not journalled', async () => {
    const journal = new MemoryJournal();
    const table = new Table(await startLocalEngine(), journal);
    await table.run({ name: 'add_character', character: 'mannequin' });
    expect(await table.run({ name: 'delete_stroke', stroke: 77 })).toBeNull();
    expect(table.toasts.value.at(-1)?.kind).toBe('error');
    expect(table.toasts.value.at(-1)?.text).toContain('77');
    expect((await journal.entries(0)).length).toBe(1);
  });

  it('a long session comes back from where it was last kept, and undo still reaches its beginning', async () => {
    const random = seeded(4);
    const journal = new MemoryJournal();
    const table = new Table(await startLocalEngine(), journal);
    await table.run({ name: 'add_character', character: 'cat' });
    const looks = [await look(table)];
    const go = async (steps: number): Promise<void> => {
      for (const until = looks.length + steps; looks.length < until; ) {
        const { actors, strokes } = table.state.value;
        const actor = actors[0]!.id;
        const command: Command =
          random() < 0.5 || strokes.length === 0
            ? { name: 'draw', actor, samples: curve(random), camera, settings: {} }
            : { name: 'rotate', actor, joint: Math.floor(random() * 20), rotation_model: [0, 0.2 * random(), 0.1, 0.97] };
        if (await table.run(command)) looks.push(await look(table));
      }
    };
    await go(20);
    await table.keepCheckpoint();
    await go(3);

    const engine = await startLocalEngine();
    let played = 0;
    const commit = engine.commit.bind(engine);
    engine.commit = (command, bytes) => ((played += 1), commit(command, bytes));
    const later = new Table(engine, journal);
    expect(await later.replay()).toBe(true);
    expect(played).toBe(3);
    expect(await look(later)).toBe(looks.at(-1));
    for (let i = looks.length - 2; i >= 0; --i) {
      await later.undo();
      expect(await look(later), `step ${i}`).toBe(looks[i]);
    }
    expect(played, 'those before were played when they were asked for').toBe(3 + looks.length);

    await later.redo();
    const third = new Table(await startLocalEngine(), journal);
    await third.replay();
    expect(await look(third), 'undone below what was kept').toBe(looks[1]);
  });

  it('a journal is played from where the project was kept only if no step goes below', () => {
    const steps = (text: string): Entry[] =>
      [...text].map((c): Entry => (c === 'c' ? { kind: 'commit', command: { name: 'clear' } } : { kind: c === 'u' ? 'undo' : 'redo' }));
    for (const above of ['', 'ccc', 'ccuu', 'cur', 'cucu', 'curu']) expect(stepsStayAbove(steps(above)), above).toBe(true);
    for (const below of ['u', 'cuu', 'curuu', 'cucuu', 'rcuu']) expect(stepsStayAbove(steps(below)), below).toBe(false);
  });

  it('thumbnails of poses change nothing on the table', async () => {
    const table = new Table(await startLocalEngine(), new MemoryJournal());
    await table.run({ name: 'add_character', character: 'mannequin' });
    const actor = table.state.value.actors[0]!.id;
    const before = await look(table);
    const { poses } = await table.engine.query<{ poses: { pose: string; kind: string }[] }>('shelf', { actor });
    const frames = await table.engine.poseFrames(poses.map(({ pose }): Command => ({ name: 'apply_pose', actor, pose, strength: 1, flipped: false })));
    expect(frames.length).toBeGreaterThanOrEqual(32);
    expect(frames.every((frame) => frame !== null && frame.palette.length > 0)).toBe(true);
    expect(await look(table)).toBe(before);
  });
});
