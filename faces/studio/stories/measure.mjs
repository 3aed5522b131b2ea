// SPDX-License-Identifier: MIT
// Prints what the built studio weighs and costs (docs/performance.md): download, the processor time of one live update of
// a growing line in the engine alone, time to the first picture, and what a pen event costs in the page. Run by
// `npm run measure`; all but processor time and download mean something on a machine that does nothing else only.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { arc, launch, ROOT, servePage, Visit } from './table.mjs';

const percentile = (values, part) => [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(part * values.length))];

const folder = join(ROOT, 'build/studio/assets');
const files = readdirSync(folder).map((name) => readFileSync(join(folder, name)));
const total = (squeeze) => Math.round(files.reduce((sum, file) => sum + squeeze(file).length, 0) / 1000);
console.log(`download: ${total((x) => x)} kB, gzip ${total(gzipSync)} kB, brotli ${total(brotliCompressSync)} kB`);

const { default: createModule } = await import('../wasm/croquis.mjs');
const module = await createModule({ wasmBinary: readFileSync(join(ROOT, 'faces/studio/wasm/croquis.wasm')) });
const table = new module.Table();
const { state } = JSON.parse(table.execute('{"name": "add_character", "character": "mannequin"}', new Uint8Array()));
const camera = { projection: 'perspective', fov_degrees: 20, position: [0, 0.9, 6.5], target: [0, 0.9, 0], up: [0, 1, 0], width: 800, height_px: 600 };
const costs = [];
for (let stroke = 0; stroke < 6; ++stroke) {
  const samples = [];
  for (let i = 0; i < 60; ++i) {
    const t = i / 59;
    samples.push([400 + 60 * (stroke - 2.5) * t * (1 - t), 520 - 420 * t, i / 60, 0.5]);
    if (i < 4) continue;
    const command = JSON.stringify({ name: 'draw', actor: state.actors[0].id, samples, camera, settings: { body_line: 'auto' } });
    const started = process.cpuUsage();
    table.preview(command);
    table.palette(state.actors[0].id, false);
    const { user, system } = process.cpuUsage(started);
    costs.push((user + system) / 1000);
  }
  table.cancelPreview();
}
console.log(`live update, processor time: median ${percentile(costs, 0.5).toFixed(1)} ms, p95 ${percentile(costs, 0.95).toFixed(1)} ms, of ${costs.length}`);

const server = await servePage();
const browser = await launch();
const url = `http://127.0.0.1:${server.address().port}/`;
const readyAt = (visit) => visit.page.evaluate(() => Math.round(performance.getEntriesByName('croquis-ready')[0].startTime));
const [firsts, laters] = [[], []];
for (let i = 0; i < 3; ++i) {
  const visit = await Visit.open(browser, url);
  firsts.push(await readyAt(visit));
  await visit.page.evaluate(() => globalThis.croquis.table.keepCheckpoint());
  await visit.page.reload();
  await visit.ready();
  laters.push(await readyAt(visit));
  await visit.context.close();
}
console.log(`first picture of the mannequin, cold cache, loopback: ${firsts.join(', ')} ms; of a later visit: ${laters.join(', ')} ms`);

// From a pen event to the pose in the page, the engine in its worker; nothing is drawn meanwhile, because what a software
// renderer takes for a frame would be in it too.
const visit = await Visit.open(browser, url);
await visit.until(() => document.querySelector('.pose-card') && !document.querySelector('.pose-card .blank'));
const [foot, head] = [await visit.pixel('rightFoot'), await visit.pixel('head')];
const roundTrips = await visit.page.evaluate(async (points) => {
  const { stage, table } = globalThis.croquis;
  const costs = [];
  for (let stroke = 0; stroke < 6; ++stroke) {
    const samples = [];
    for (const { x, y } of points) {
      samples.push([x + stroke, y, samples.length / 60, 0.5]);
      const command = { name: 'draw', actor: table.actor.value, samples, camera: stage.rig.toSpec(), settings: table.drawing.value };
      const started = performance.now();
      const change = await new Promise((done, failed) => table.engine.preview(command, done, failed));
      costs.push({ all: performance.now() - started, solve: change.timing.solve_ms, engine: change.timing.engine_ms });
    }
    await table.engine.cancelPreview();
  }
  return costs;
}, arc(foot, { x: (foot.x + head.x) / 2 + 40, y: (foot.y + head.y) / 2 }, { x: head.x + 90, y: head.y + 20 }, 60));
const column = (key) => `${key} ${percentile(roundTrips.map((t) => t[key]), 0.5).toFixed(1)} / ${percentile(roundTrips.map((t) => t[key]), 0.95).toFixed(1)}`;
console.log(`pen event to pose in the page, ms, median / p95 of ${roundTrips.length}: ${['solve', 'engine', 'all'].map(column).join(', ')}`);
await browser.close();
server.close();
