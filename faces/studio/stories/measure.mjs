// SPDX-License-Identifier: MIT
// Prints what the built studio weighs and costs (docs/performance.md): download, time to the first picture, and the
// processor time of one live update of a growing line in the engine alone. Run by `npm run measure`.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { launch, ROOT, servePage, Visit } from './table.mjs';

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
const firsts = [];
for (let i = 0; i < 3; ++i) {
  const visit = await Visit.open(browser, `http://127.0.0.1:${server.address().port}/`);
  firsts.push(await visit.page.evaluate(() => performance.getEntriesByName('croquis-ready')[0]?.startTime ?? NaN));
  await visit.context.close();
}
console.log(`first picture of the mannequin, cold cache, loopback: ${firsts.map((ms) => Math.round(ms)).join(', ')} ms`);
await browser.close();
server.close();
