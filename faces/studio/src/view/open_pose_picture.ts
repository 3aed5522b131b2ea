// SPDX-License-Identifier: MIT
// The figure of OpenPose's COCO model: 18 points, limbs and points in a ramp of 18 hues on black.
const LIMBS: [number, number][] = [
  [1, 2], [1, 5], [2, 3], [3, 4], [5, 6], [6, 7], [1, 8], [8, 9], [9, 10], [1, 11], [11, 12], [12, 13], [1, 0], [0, 14], [14, 16], [0, 15], [15, 17],
];
const STEPS = [0, 85, 170, 255];

/** The hues of the model: red, over yellow, green, cyan and blue, to magenta and back towards red. */
function hue(i: number): string {
  const up = STEPS[i % 3]!;
  const down = 255 - up;
  const [r, g, b] = ([[255, up, 0], [down, 255, 0], [0, 255, up], [0, down, 255], [up, 0, 255], [255, 0, down]] as const)[Math.floor(i / 3) % 6]!;
  return `rgb(${r} ${g} ${b})`;
}

interface People {
  people: { pose_keypoints_2d: number[] }[];
  width: number;
  height: number;
}

export function drawOpenPose(json: string): HTMLCanvasElement {
  const { people, width, height } = JSON.parse(json) as People;
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width, height });
  const c = canvas.getContext('2d')!;
  c.fillRect(0, 0, width, height);
  const unit = Math.max(width, height) / 512;
  for (const { pose_keypoints_2d: numbers } of people) {
    const at = (i: number) => ({ x: numbers[3 * i]!, y: numbers[3 * i + 1]!, seen: numbers[3 * i + 2]! > 0 });
    c.globalAlpha = 0.6;
    LIMBS.forEach(([from, to], i) => {
      const [a, b] = [at(from), at(to)];
      if (!a.seen || !b.seen) return;
      c.fillStyle = hue(i);
      c.beginPath();
      c.ellipse((a.x + b.x) / 2, (a.y + b.y) / 2, Math.hypot(b.x - a.x, b.y - a.y) / 2, 4 * unit, Math.atan2(b.y - a.y, b.x - a.x), 0, 7);
      c.fill();
    });
    c.globalAlpha = 1;
    for (let i = 0; i < 18; ++i) {
      const { x, y, seen } = at(i);
      if (!seen) continue;
      c.fillStyle = hue(i);
      c.beginPath();
      c.arc(x, y, 4 * unit, 0, 7);
      c.fill();
    }
  }
  return canvas;
}
