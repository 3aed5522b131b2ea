// SPDX-License-Identifier: MIT
import { beforeEach, describe, expect, it } from 'vitest';
import { Gestures, type GestureActions, type PointerSample } from '../src/tools/gestures';

let log: string[];
let gestures: Gestures;

function point(type: string, id: number, x = 0, y = 0, more: Partial<PointerSample> = {}): PointerSample {
  return { id, type, button: 0, x, y, time: 0, pressure: 0.5, alt: false, shift: false, space: false, ...more };
}

beforeEach(() => {
  log = [];
  const note = (name: string) => () => void log.push(name);
  const names = ['toolDown', 'toolMove', 'toolUp', 'toolCancel', 'hover', 'orbit', 'pan', 'zoom', 'undo', 'redo'];
  gestures = new Gestures(Object.fromEntries(names.map((name) => [name, note(name)])) as unknown as GestureActions);
});

describe('gestures', () => {
  it('draws with the left button and with a pen', () => {
    for (const type of ['mouse', 'pen']) {
      log = [];
      gestures.pointerDown(point(type, 1));
      gestures.pointerMove(point(type, 1, 5));
      gestures.pointerUp(point(type, 1, 5));
      expect(log).toEqual(['toolDown', 'toolMove', 'toolUp']);
    }
  });

  it('orbits with the right button, Alt or Space, and pans with Shift', () => {
    for (const how of [{ button: 2 }, { alt: true }, { space: true }]) {
      gestures.pointerDown(point('mouse', 1, 0, 0, how));
      gestures.pointerMove(point('mouse', 1, 5));
      gestures.pointerUp(point('mouse', 1, 5));
    }
    gestures.pointerDown(point('mouse', 1, 0, 0, { button: 2, shift: true }));
    gestures.pointerMove(point('mouse', 1, 5));
    gestures.pointerUp(point('mouse', 1, 5));
    expect(log).toEqual(['orbit', 'orbit', 'orbit', 'pan']);
  });

  it('draws with one finger until a pen has been seen, then orbits', () => {
    gestures.pointerDown(point('touch', 1));
    gestures.pointerUp(point('touch', 1));
    gestures.pointerDown(point('pen', 2));
    gestures.pointerUp(point('pen', 2));
    gestures.pointerDown(point('touch', 3));
    gestures.pointerMove(point('touch', 3, 9));
    gestures.pointerUp(point('touch', 3, 9));
    expect(log).toEqual(['toolDown', 'toolUp', 'toolDown', 'toolUp', 'orbit']);
  });

  it('ignores the palm while a pen is down', () => {
    gestures.pointerDown(point('pen', 1));
    expect(gestures.pointerDown(point('touch', 2))).toBe(false);
    gestures.pointerMove(point('touch', 2, 50));
    gestures.pointerUp(point('pen', 1));
    expect(log).toEqual(['toolDown', 'toolUp']);
  });

  it('a pen takes over from a palm that came first', () => {
    gestures.pointerDown(point('touch', 1));
    gestures.pointerDown(point('pen', 2));
    gestures.pointerMove(point('pen', 2, 4));
    expect(log).toEqual(['toolDown', 'toolCancel', 'toolDown', 'toolMove']);
  });

  it('two fingers navigate and take back what the first began', () => {
    gestures.pointerDown(point('touch', 1, 0, 0));
    gestures.pointerDown(point('touch', 2, 100, 0));
    gestures.pointerMove(point('touch', 1, -40, 0));
    gestures.pointerMove(point('touch', 2, 160, 0));
    expect(log[0]).toBe('toolDown');
    expect(log[1]).toBe('toolCancel');
    expect(log).toContain('zoom');
    expect(log).not.toContain('toolMove');
  });

  it('a tap of two fingers undoes, of three redoes, a slow one does nothing', () => {
    const tap = (count: number, ms: number) => {
      for (let i = 1; i <= count; ++i) gestures.pointerDown(point('touch', i, 30 * i, 0));
      for (let i = 1; i <= count; ++i) gestures.pointerUp(point('touch', i, 30 * i, 0, { time: ms }));
    };
    tap(2, 100);
    tap(3, 100);
    tap(2, 900);
    expect(log.filter((name) => name === 'undo' || name === 'redo')).toEqual(['undo', 'redo']);
  });

  it('locks the camera while the tool is at work, and Escape takes the tool back', () => {
    gestures.pointerDown(point('mouse', 1));
    gestures.wheel(100);
    gestures.cancel();
    gestures.pointerUp(point('mouse', 1));
    expect(log).toEqual(['toolDown', 'toolCancel']);
    expect(gestures.path).toBe('idle');
  });

  it('a pointer that the system takes away leaves nothing half done', () => {
    gestures.pointerDown(point('pen', 1));
    gestures.pointerCancel(point('pen', 1));
    expect(log).toEqual(['toolDown', 'toolCancel']);
    expect(gestures.path).toBe('idle');
  });
});
