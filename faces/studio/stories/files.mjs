// SPDX-License-Identifier: MIT
// What comes in and what goes out.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { lean, story, written } from './play.mjs';
import { DATA, distance } from './table.mjs';

const require = createRequire(import.meta.url);

/** A file that begins like a GLB and goes on as nothing. */
const brokenFile = () => written('broken.glb', Buffer.concat([Buffer.from('glTF'), Buffer.alloc(30, 7)]));

async function saved(visit, format) {
  const text = await visit.page.evaluate(async (f) => {
    const { table, stage } = globalThis.croquis;
    const bytes = await table.engine.export(f, table.actor.value, { camera: stage.rig.toSpec() });
    const reader = new FileReader();
    reader.readAsDataURL(new Blob([bytes]));
    await new Promise((done) => (reader.onload = done));
    return reader.result;
  }, format);
  return Buffer.from(text.slice(text.indexOf(',') + 1), 'base64');
}

story('characters of every kind are dropped on the table; a broken one is told of and does no harm', { data: true }, async (visit) => {
  for (const file of ['gltf/cesium_man.gltf', 'gltf/fox_khronos.glb', 'gltf/quaternius_man_casual.glb', 'vrm/cryptovoxels_vrm0.vrm', 'vrm/debug_robot_vrm1.vrm', 'bvh/cmu_01_01.bvh']) {
    const toast = await visit.drop(join(DATA, file));
    assert.equal(toast.kind, 'note', `${file}: ${toast.text}`);
  }
  const { actors } = await visit.state();
  assert.equal(actors.length, 7);
  assert.ok(actors.some((actor) => actor.licence), 'the licence of a VRM is known');
  const before = JSON.stringify(await visit.state());
  const toast = await visit.drop(brokenFile());
  assert.equal(toast.kind, 'error');
  assert.ok(toast.text.length > 10);
  assert.equal(JSON.stringify(await visit.state()), before, 'the scene is unharmed');
});

story('every format is exported, GLB and VRM pass the validator, the picture is not flat', {}, async (visit) => {
  const validator = require('gltf-validator');
  await visit.draw(await lean(visit));
  for (const format of ['croquis', 'glb', 'vrm', 'bvh', 'svg', 'openpose']) {
    const bytes = await saved(visit, format);
    assert.ok(bytes.length > 200, format);
    if (format === 'glb' || format === 'vrm' || format === 'croquis') {
      const report = await validator.validateBytes(new Uint8Array(bytes));
      assert.equal(report.issues.numErrors, 0, `${format}: ${JSON.stringify(report.issues.messages.slice(0, 3))}`);
    }
    if (format === 'openpose') assert.equal(JSON.parse(bytes.toString()).people[0].pose_keypoints_2d.length, 54);
    if (format === 'bvh') assert.match(bytes.toString(), /^HIERARCHY[\s\S]*Frames: 1/);
    if (format === 'svg') assert.match(bytes.toString(), /<path/);
  }
  const levels = await visit.page.evaluate(async () => {
    const shades = async (blob) => {
      const image = await createImageBitmap(blob);
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      return { size: [image.width, image.height], shades: new Set(data).size, clear: data[3] === 0 };
    };
    const { croquis } = globalThis;
    const usual = { transparent: false, strokes: true, backdrop: false };
    const narrow = { width: 200, height: 300, transparent: true, strokes: false };
    const { pictures } = croquis;
    return [await pictures.png({ ...usual, width: 320, height: 240 }), await pictures.png({ ...usual, ...narrow }), await pictures.openPose()].reduce(
      async (all, blob) => [...(await all), await shades(blob)], []);
  });
  assert.deepEqual(levels[0].size, [320, 240]);
  assert.ok(levels[0].shades > 60 && !levels[0].clear, 'the picture has many shades');
  assert.deepEqual(levels[1].size, [200, 300]);
  assert.ok(levels[1].shades > 60 && levels[1].clear, 'without a background its corner is clear');
  assert.ok(levels[2].shades > 10, 'the OpenPose figure is drawn');
  await visit.page.locator('summary', { hasText: 'File' }).click();
  const [file] = await Promise.all([visit.page.waitForEvent('download'), visit.page.getByRole('button', { name: 'BVH' }).click()]);
  assert.match(file.suggestedFilename(), /\.bvh$/);
});

story('lines and the picture to trace lie in the PNG where they lie on the table', {}, async (visit) => {
  await visit.draw(await lean(visit));
  const told = await visit.page.evaluate(async () => {
    const { croquis } = globalThis;
    const red = Object.assign(document.createElement('canvas'), { width: 40, height: 10 });
    Object.assign(red.getContext('2d'), { fillStyle: '#f00' }).fillRect(0, 0, 40, 10);
    await croquis.openFile(new File([await new Promise((done) => red.toBlob(done))], 'red.png', { type: 'image/png' }));
    const [width, height] = [400, 800]; // narrower than the table: its sides are cut off
    const pixels = async (options) => {
      const image = await createImageBitmap(await croquis.pictures.png({ width, height, transparent: true, strokes: false, backdrop: false, ...options }));
      const context = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d');
      context.drawImage(image, 0, 0);
      return (x, y) => [...context.getImageData(Math.round(x), Math.round(y), 1, 1).data];
    };
    const { clientWidth, clientHeight } = croquis.stage.canvas;
    const scale = height / clientHeight;
    const [x, y] = croquis.table.state.value.strokes[0].samples.at(-1);
    const end = [width / 2 + (x - clientWidth / 2) * scale, y * scale];
    const [plain, drawn, traced] = [await pixels({}), await pixels({ strokes: true }), await pixels({ backdrop: true })];
    return { plain: plain(...end), drawn: drawn(...end), above: traced(5, height / 2 - 0.11 * clientWidth * scale), beyond: traced(5, height / 2 - 0.14 * clientWidth * scale) };
  });
  assert.ok(distance(told.plain, told.drawn) > 50, 'the end of the line is there');
  assert.ok(told.above[0] > 200 && told.above[3] > 100, 'the picture is as wide as the table');
  assert.equal(told.beyond[3], 0, 'and no higher than it is');
});
