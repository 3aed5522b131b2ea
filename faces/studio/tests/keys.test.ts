// SPDX-License-Identifier: MIT
import { describe, expect, it, vi } from 'vitest';
import type { Studio } from '../src/studio';

vi.stubGlobal('matchMedia', () => ({ matches: false }));
vi.stubGlobal('navigator', { language: 'en' });
vi.stubGlobal('document', { documentElement: { dataset: {}, lang: '' } });
const { actionFor, keyOf, makeActions } = await import('../src/ui/actions');

function pressed(key: string, code: string, held: string[] = []): KeyboardEvent {
  const has = (name: string): boolean => held.includes(name);
  return {
    key, code, ctrlKey: has('Ctrl'), altKey: has('Alt'), shiftKey: has('Shift'), metaKey: has('Meta'), getModifierState: has,
  } as unknown as KeyboardEvent;
}

describe('keys', () => {
  it('are read as a person says them', () => {
    expect(keyOf(pressed('z', 'KeyZ', ['Ctrl']))).toBe('Ctrl+Z');
    expect(keyOf(pressed('Z', 'KeyZ', ['Meta', 'Shift']))).toBe('Ctrl+Shift+Z');
    expect(keyOf(pressed('1', 'Numpad1', ['Ctrl']))).toBe('Ctrl+Numpad1');
    expect(keyOf(pressed('Delete', 'Delete'))).toBe('Delete');
  });

  it('work on keyboards of other countries', () => {
    expect(keyOf(pressed('&', 'Digit1')), 'a French 1').toBe('1');
    expect(keyOf(pressed('[', 'Digit5', ['Ctrl', 'Alt', 'AltGraph'])), 'a French [').toBe('[');
    expect(keyOf(pressed('z', 'KeyY', ['Ctrl'])), 'a German Z').toBe('Ctrl+Z');
  });

  it('none of them means two things at a time', () => {
    const actions = makeActions({ table: {} } as unknown as Studio);
    for (const tool of [undefined, 'draw', 'drag', 'rotate', 'select']) {
      const keys = actions.filter((action) => action.tool === tool).flatMap((action) => action.keys);
      expect(keys.filter((key, i) => keys.indexOf(key) !== i)).toEqual([]);
      if (!tool) expect(keys.length).toBeGreaterThan(30);
    }
  });

  it('X deletes a line, and holds an axis while joints are rotated', () => {
    const actions = makeActions({ table: {} } as unknown as Studio);
    expect(actionFor(actions, 'X', 'draw')?.id).toBe('delete');
    expect(actionFor(actions, 'X', 'rotate')?.id).toBe('axis.x');
    expect(actionFor(actions, 'Z', 'draw')).toBeUndefined();
    expect(actionFor(actions, 'M', 'rotate')?.id).toBe('mirror');
  });
});
