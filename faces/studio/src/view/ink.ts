// SPDX-License-Identifier: MIT
// Strokes as ink on a sheet of glass over the picture: a 2-D canvas, so that a line is as crisp as the screen and a
// pen's newest sample is there at once, before the engine has answered.
import type { Sample } from '../engine/protocol';

export interface InkLine {
  points: { x: number; y: number; pressure: number }[];
  color: string;
  width: number;
  dashed?: boolean;
  /** Draw the points as handles that can be dragged. */
  handles?: boolean;
}

export function toPoints(samples: Sample[]): InkLine['points'] {
  return samples.map(([x, y, , pressure]) => ({ x, y, pressure }));
}

export interface Marker {
  x: number;
  y: number;
  color: string;
  radius: number;
  hollow?: boolean;
}

export class InkLayer {
  private readonly context: CanvasRenderingContext2D;
  private ratio = 1;

  constructor(readonly canvas: HTMLCanvasElement) {
    this.context = canvas.getContext('2d')!;
  }

  resize(width: number, height: number, ratio: number): void {
    this.ratio = ratio;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
  }

  draw(lines: InkLine[], bones: [Marker, Marker, string][], markers: Marker[]): void {
    const c = this.context;
    c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    c.clearRect(0, 0, this.canvas.width, this.canvas.height);
    for (const [from, to, color] of bones) this.bone(from, to, color);
    for (const marker of markers) this.marker(marker);
    for (const line of lines) this.line(line);
  }

  private bone(from: Marker, to: Marker, color: string): void {
    const c = this.context;
    const dx = to.x - from.x;
    const dy = to.y - from.y;
    const length = Math.hypot(dx, dy) || 1;
    const half = Math.min(6, length * 0.12);
    c.beginPath();
    c.moveTo(from.x, from.y);
    c.lineTo(from.x + dx * 0.15 - (dy / length) * half, from.y + dy * 0.15 + (dx / length) * half);
    c.lineTo(to.x, to.y);
    c.lineTo(from.x + dx * 0.15 + (dy / length) * half, from.y + dy * 0.15 - (dx / length) * half);
    c.closePath();
    c.globalAlpha = 0.55;
    c.fillStyle = color;
    c.fill();
    c.globalAlpha = 1;
  }

  private marker({ x, y, color, radius, hollow }: Marker): void {
    const c = this.context;
    c.beginPath();
    c.arc(x, y, radius, 0, 2 * Math.PI);
    c.lineWidth = 2;
    c.strokeStyle = color;
    c.fillStyle = hollow ? 'rgba(255,255,255,0.75)' : color;
    c.fill();
    c.stroke();
  }

  /** A ribbon whose width follows the pressure and tapers at both ends. */
  private line({ points, color, width, dashed, handles }: InkLine): void {
    const c = this.context;
    if (points.length === 0) return;
    c.lineCap = c.lineJoin = 'round';
    c.strokeStyle = color;
    c.setLineDash(dashed ? [6, 6] : []);
    const middle = (i: number) => ({ x: (points[i]!.x + points[i + 1]!.x) / 2, y: (points[i]!.y + points[i + 1]!.y) / 2 });
    for (let i = 0; i < points.length; ++i) {
      const at = points[i]!;
      const [from, to] = [i > 0 ? middle(i - 1) : at, i + 1 < points.length ? middle(i) : at];
      const end = Math.min(i + 1, points.length - i) / Math.min(12, points.length);
      c.lineWidth = width * (0.55 + 0.9 * at.pressure) * Math.min(1, 0.45 + end);
      c.beginPath();
      c.moveTo(from.x, from.y);
      c.quadraticCurveTo(at.x, at.y, to.x, to.y);
      c.stroke();
    }
    c.setLineDash([]);
    if (!handles) return;
    for (const { x, y } of handlePoints(points)) this.marker({ x, y, color, radius: 7, hollow: true });
  }
}

/** The points of a line that can be dragged: both ends and a few between, at equal counts. */
export const HANDLES = 7;
export function handleIndices(count: number): number[] {
  if (count <= HANDLES) return Array.from({ length: count }, (_, i) => i);
  return Array.from({ length: HANDLES }, (_, i) => Math.round((i * (count - 1)) / (HANDLES - 1)));
}

function handlePoints<T>(points: T[]): T[] {
  return handleIndices(points.length).map((i) => points[i]!);
}

/** The line with point `index` dragged by (dx, dy): its neighbours follow, less and less, up to the next handles. */
export function dragPoint(samples: Sample[], index: number, dx: number, dy: number): Sample[] {
  const reach = Math.max(1, (samples.length - 1) / (HANDLES - 1));
  return samples.map(([x, y, time, pressure], i) => {
    const away = Math.min(1, Math.abs(i - index) / reach);
    const share = 0.5 + 0.5 * Math.cos(Math.PI * away);
    return [x + dx * share, y + dy * share, time, pressure];
  });
}
