// SPDX-License-Identifier: MIT
import { beforeEach, describe, expect, it } from 'vitest';
import type { Command, Quat, Vec3 } from '../src/engine/protocol';
import { RotateTool, type BodyContext } from '../src/tools/body_tools';
import type { PointerSample } from '../src/tools/gestures';

const p = (x: number, y: number, shift = false): PointerSample => ({
  id: 1, type: 'mouse', button: 0, x, y, time: 0, pressure: 0.5, alt: false, shift, space: false,
});

let elsewhere: boolean;
let held: Vec3 | null;
let shown: Quat | null;
let committed: Command[];
let tool: RotateTool;

/** The viewer looks along -Z: x is right, y up, z toward him. The joint is at the pixel (100, 100). */
beforeEach(() => {
  elsewhere = false;
  held = null;
  shown = null;
  committed = [];
  const context: Partial<BodyContext> = {
    actor: () => 1,
    jointAt: () => (elsewhere ? null : 3),
    takeActorAt: () => ((elsewhere = false), true),
    jointPixel: () => ({ x: 100, y: 100 }),
    viewAxis: () => [0, 0, 1],
    heldAxis: () => held,
    axisInView: ([x, y, toward]) => ({ x, y, toward }),
    boneAxis: () => [0, 1, 0],
    selectJoint: () => {},
    preview: (command) => (shown = (command as Extract<Command, { name: 'rotate' }>).rotation_model),
    commit: (command) => committed.push(command),
    cancelPreview: () => (shown = null),
  };
  tool = new RotateTool(context as BodyContext);
});

const angle = ([x, y, z, w]: Quat): number => 2 * Math.atan2(Math.hypot(x, y, z) * Math.sign(x + y + z), w);

describe('rotate tool', () => {
  it('turns with the hand about the line of sight', () => {
    tool.down(p(200, 100));
    tool.move([p(100, 0)]); // a quarter turn to the left, as seen
    expect(shown![2]).toBeGreaterThan(0);
    expect(angle(shown!)).toBeCloseTo(Math.PI / 2);
    tool.up();
    expect(committed.length).toBe(1);
  });

  it('held to an axis toward the viewer it turns as in the view, held to one away from him the other way', () => {
    held = [0, 0, 1];
    tool.down(p(200, 100));
    tool.move([p(100, 0)]);
    expect(angle(shown!)).toBeCloseTo(Math.PI / 2);
    held = [0, 0, -1];
    tool.turned();
    expect(shown![2] / Math.abs(shown![2])).toBe(1); // the other way about the opposite axis is the same
  });

  it('held to an upright axis it follows the hand to the side, held to one across it follows it up and down', () => {
    held = [0, 1, 0];
    tool.down(p(150, 100));
    tool.move([p(190, 60)]);
    expect(shown![1], 'what faces the viewer goes right').toBeGreaterThan(0);
    expect(shown!.filter((_, i) => i === 0 || i === 2)).toEqual([0, 0]);
    held = [1, 0, 0];
    tool.turned(); // the axis is changed in the middle of the turn
    expect(shown![0], 'what faces the viewer goes up').toBeLessThan(0);
    expect(shown![1]).toBeCloseTo(0);
  });

  it('with Shift it twists about the bone, whatever is held', () => {
    held = [1, 0, 0];
    tool.down(p(150, 100, true));
    tool.move([p(200, 100, true)]);
    expect(angle(shown!)).toBeCloseTo(0.6);
    expect(shown![1]).toBeGreaterThan(0);
  });

  it('takes another character in hand by its joint', () => {
    elsewhere = true;
    tool.down(p(150, 100));
    expect(tool.path).toBe('rotate.turning');
  });

  it('Escape takes it back', () => {
    tool.down(p(150, 100));
    tool.move([p(200, 100)]);
    tool.cancel();
    tool.up();
    expect(shown).toBeNull();
    expect(committed).toEqual([]);
  });
});
