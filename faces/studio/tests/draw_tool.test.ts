// SPDX-License-Identifier: MIT
import { beforeEach, describe, expect, it } from 'vitest';
import type { CameraSpec, Command, Sample, StrokeInfo } from '../src/engine/protocol';
import { DrawTool, redrawPart } from '../src/tools/draw_tool';
import type { PointerSample } from '../src/tools/gestures';
import { dragPoint, handleIndices } from '../src/view/ink';

const camera = { width: 800, height_px: 600 } as CameraSpec;
const p = (x: number, y: number, time = 0, pressure = 0.5): PointerSample => ({
  id: 1, type: 'pen', button: 0, x, y, time, pressure, alt: false, shift: false, space: false,
});
const straight: Sample[] = Array.from({ length: 31 }, (_, i) => [10 * i, 100, i / 60, 0.5]);

let previews: Command[];
let commits: Command[];
let cancelled: number;
let selected: StrokeInfo | null;
let refused: boolean;
let tool: DrawTool;

beforeEach(() => {
  previews = [];
  commits = [];
  cancelled = 0;
  selected = null;
  refused = false;
  tool = new DrawTool({
    editable: () => selected,
    camera: () => camera,
    refuses: () => refused,
    aim: () => {},
    drawCommand: (samples, at) => ({ name: 'draw', actor: 0, samples: [...samples], camera: at, settings: {} }),
    preview: (command) => previews.push(command),
    commit: (command) => commits.push(command),
    cancelPreview: () => void cancelled++,
    showInk: () => {},
  });
});

describe('draw tool', () => {
  it('previews while drawing and commits one command on release', () => {
    tool.down(p(0, 0, 1000, 0.3));
    expect(tool.path).toBe('draw.drawing');
    for (let i = 1; i <= 20; ++i) tool.move([p(5 * i, 0, 1000 + 8 * i, 0.6)]);
    tool.up(p(100, 0, 1200));
    expect(tool.path).toBe('draw.idle');
    expect(previews.length).toBeGreaterThan(10);
    expect(commits.length).toBe(1);
    const command = commits[0] as Extract<Command, { name: 'draw' }>;
    expect(command.samples[0]).toEqual([0, 0, 0, 0.3]);
    expect(command.samples.at(-1)!.slice(0, 2)).toEqual([100, 0]);
    expect(command.samples[1]![3]).toBe(0.6);
  });

  it('takes a dot for a slip of the hand', () => {
    tool.down(p(0, 0));
    tool.move([p(1, 1)]);
    tool.up(p(1, 1));
    expect(commits).toEqual([]);
    expect(cancelled).toBe(1);
  });

  it('draws nothing where no line can be drawn', () => {
    refused = true;
    tool.down(p(0, 0));
    tool.move([p(50, 0)]);
    tool.up(p(60, 0));
    expect([previews, commits, cancelled]).toEqual([[], [], 0]);
  });

  it('Escape takes the preview back', () => {
    tool.down(p(0, 0));
    tool.move([p(50, 0)]);
    tool.cancel();
    tool.up(p(60, 0));
    expect(commits).toEqual([]);
    expect(cancelled).toBe(1);
  });

  it('drags a point of the selected line', () => {
    selected = { id: 4, samples: straight } as StrokeInfo;
    tool.down(p(300, 101));
    expect(tool.path).toBe('draw.point');
    tool.move([p(300, 151)]);
    tool.up(p(300, 151));
    const command = commits[0] as Extract<Command, { name: 'redraw' }>;
    expect(command.stroke).toBe(4);
    expect(command.samples.at(-1)![1]).toBeCloseTo(150);
    expect(command.samples[0]![1]).toBe(100);
  });

  it('redraws the part drawn over, and leaves the rest', () => {
    selected = { id: 4, samples: straight } as StrokeInfo;
    tool.down(p(122, 104));
    expect(tool.path).toBe('draw.part');
    tool.move([p(150, 60), p(180, 60)]);
    tool.up(p(210, 101));
    const { samples } = commits[0] as Extract<Command, { name: 'redraw' }>;
    expect(samples[0]!.slice(0, 2)).toEqual([0, 100]);
    expect(samples.at(-1)!.slice(0, 2)).toEqual([300, 100]);
    expect(Math.min(...samples.map((s) => s[1]))).toBe(60);
  });
});

describe('line editing', () => {
  it('a part drawn against the line keeps the direction of the line', () => {
    const merged = redrawPart(straight, [[200, 100, 0, 1], [150, 140, 0, 1], [100, 100, 0, 1]]);
    const xs = merged.map((s) => s[0]);
    expect([...xs].sort((a, b) => a - b)).toEqual(xs);
  });

  it('handles include both ends', () => {
    expect(handleIndices(100)[0]).toBe(0);
    expect(handleIndices(100).at(-1)).toBe(99);
    expect(handleIndices(3)).toEqual([0, 1, 2]);
  });

  it('a dragged point moves by as much as the hand, its far neighbours not at all', () => {
    const moved = dragPoint(straight, 15, 0, 20);
    expect(moved[15]![1]).toBe(120);
    expect(moved[0]![1]).toBe(100);
    expect(moved[14]![1]).toBeGreaterThan(110);
  });
});
