// SPDX-License-Identifier: MIT
// `?perf`: what a pen event costs, by station: solving, the engine as a whole, the way there and back, drawing.
import type { Studio } from '../studio';

export function percentile(values: number[], part: number): number {
  if (values.length === 0) return 0;
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))]!;
}

export function startMeter(studio: Studio, parent: HTMLElement): void {
  const box = document.createElement('output');
  box.className = 'meter';
  parent.append(box);
  setInterval(() => {
    const timings = studio.table.timings;
    const line = (label: string, values: number[]): string =>
      `${label} ${percentile(values, 0.5).toFixed(1)} / ${percentile(values, 0.95).toFixed(1)} ms`;
    box.textContent = [
      line('solve', timings.map((x) => x.solve_ms)),
      line('engine', timings.map((x) => x.engine_ms)),
      line('transfer', timings.map((x) => x.transfer_ms)),
      `draw ${studio.stage.stats.drawMs.toFixed(1)} ms, ${studio.stage.stats.drawCalls} calls`,
    ].join('\n');
  }, 500);
}
