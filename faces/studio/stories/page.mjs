// SPDX-License-Identifier: MIT
// The page: views, keys, screen readers, what a frame costs, how it looks.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { place, story } from './play.mjs';
import { arc, distance, ROOT, Visit } from './table.mjs';

const require = createRequire(import.meta.url);

story('views, lens, light, proportions and a second character', {}, async (visit) => {
  const { page } = visit;
  const rig = () => page.evaluate(() => globalThis.croquis.stage.rig.toSpec());
  await page.keyboard.press('3');
  const side = await rig();
  assert.ok(await visit.run({ name: 'keep_view', view_name: 'mine', camera: side }));
  await page.keyboard.press('1');
  assert.ok(distance((await rig()).position, side.position) > 1);
  await page.keyboard.press('5');
  assert.equal((await rig()).projection, 'orthographic');
  await page.evaluate((spec) => globalThis.croquis.stage.rig.fromSpec(spec), (await visit.state()).views[0].camera);
  assert.ok(distance((await rig()).position, side.position) < 1e-6, 'back to the kept view');
  await page.keyboard.press('7');
  assert.ok(await visit.run({ name: 'set_table', settings: { floor: false } }));
  const drawn = await visit.run({ name: 'draw', actor: 1, samples: [[300, 300, 0, 0.5], [320, 250, 0.1, 0.5], [330, 200, 0.2, 0.5]], camera: await rig(), settings: { plane: 'ground', method: 'rotation' } });
  assert.equal(drawn, false, 'the upright plane is refused from straight above');
  assert.equal((await page.evaluate(() => globalThis.croquis.table.toasts.value.at(-1))).kind, 'error');
  const before = await visit.joints();
  const actor = (await visit.state()).actors[0];
  assert.ok(await visit.run({ name: 'set_proportions', actor: actor.id, proportions: { heads: 5 } }));
  assert.ok(distance(before, await visit.joints()) > 0.05, 'another body');
  await page.evaluate(() => globalThis.croquis.addCharacter('cat'));
  assert.equal((await visit.state()).actors.length, 2);
  assert.notEqual(await page.evaluate(() => globalThis.croquis.table.actor.value), actor.id, 'the newcomer is in hand');
});

story('everything can be reached with the keyboard alone', {}, async (visit) => {
  const { page } = visit;
  // As fast as a person can never type: not one letter may be lost, and none may be taken for a key of the table.
  await page.keyboard.press('Control+k');
  await page.keyboard.type('mirror pose');
  await page.keyboard.press('Enter');
  await visit.undoSays('mirror');
  assert.equal(await page.evaluate(() => globalThis.croquis.tool.value), 'draw', 'the r of mirror chose no tool');
  await page.keyboard.press('Control+k');
  await page.keyboard.type('add cat');
  await page.keyboard.press('Enter');
  await visit.until(() => globalThis.croquis.stage.characters.size === 2);
  await page.keyboard.press('7');
  await visit.until(() => globalThis.croquis.stage.rig.state.elevation > 1.5); // the top view
  await page.keyboard.press('F3');
  await page.keyboard.press('Escape');
  await page.keyboard.press('9');
  await visit.until(() => globalThis.croquis.stage.rig.state.elevation < 0.5); // the keys are the table's again
  const reached = new Set();
  for (let i = 0; i < 60; ++i) {
    await page.keyboard.press('Tab');
    reached.add(await page.evaluate(() => document.activeElement?.getAttribute('aria-label') ?? document.activeElement?.textContent?.slice(0, 30)));
  }
  assert.ok(reached.size > 15, `Tab walks through the page (${reached.size} stops)`);
});

story('nothing stands in the way of a person who cannot see or point well (axe)', {}, async (visit) => {
  const source = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
  for (const scheme of [false, true]) {
    await visit.page.evaluate((dark) => {
      document.documentElement.dataset.theme = dark ? 'dark' : 'light';
      for (const section of document.querySelectorAll('details')) section.open = true;
    }, scheme);
    // The page's own policy lets no foreign script in: the checker is handed over by the debugger.
    await visit.wire.send('Runtime.evaluate', { expression: source });
    const { result } = await visit.wire.send('Runtime.evaluate', {
      expression: `axe.run(document, { resultTypes: ['violations'] }).then((r) => JSON.stringify(r.violations.filter((v) => v.impact === 'serious' || v.impact === 'critical').map((v) => [v.id, v.nodes[0].html, v.nodes[0].failureSummary])))`,
      awaitPromise: true,
    });
    assert.equal(result.value, '[]');
  }
});

story('a frame costs one palette upload a character and few draw calls', {}, async (visit) => {
  const counts = () =>
    visit.page.evaluate(() => {
      const { stage } = globalThis.croquis;
      return { uploads: [...stage.characters.values()].map((c) => c.palette.uploads), frames: stage.stats.frames, calls: stage.stats.drawCalls };
    });
  await visit.page.waitForFunction(() => document.querySelector('.pose-card') && !document.querySelector('.pose-card .blank'));
  const before = await counts();
  const actor = (await visit.state()).actors[0].id;
  await visit.run({ name: 'reset', actor, joints: [], amount: 0.5 });
  await visit.settled();
  const after = await counts();
  assert.ok(after.uploads[0] - before.uploads[0] <= 2);
  assert.ok(after.calls < 40, `${after.calls} draw calls`);
});

story('the screenshots of the README, in full quality', {}, async (visit) => {
  mkdirSync(join(ROOT, 'build/screenshots'), { recursive: true });
  await visit.page.close();
  for (const [name, width, height] of [['studio-desktop', 1440, 900], ['studio-tablet', 1024, 768]]) {
    const table = new Visit(await place.browser.newContext({ viewport: { width, height } }), place.url);
    await table.load('');
    const { poses } = await table.page.evaluate(() => globalThis.croquis.table.engine.query('shelf', { actor: globalThis.croquis.table.actor.value }));
    const { pose } = poses.find(({ name }) => name === 'Walk');
    await table.run({ name: 'apply_pose', actor: (await table.state()).actors[0].id, pose, strength: 1, flipped: false });
    const [foot, head] = [await table.pixel('rightFoot'), await table.pixel('head')];
    const tall = foot.y - head.y;
    await table.draw(arc(foot, { x: foot.x, y: foot.y - 0.6 * tall }, { x: foot.x + 0.3 * tall, y: foot.y - 0.98 * tall }, 40));
    await table.until(() => document.querySelector('.pose-card') && !document.querySelector('.pose-card .blank'));
    await table.settled();
    const panels = await table.page.locator('.panels').boundingBox();
    assert.ok((await table.pixel('head')).x < panels.x, 'the character stands beside the panels');
    const shot = await table.page.screenshot({ path: join(ROOT, `build/screenshots/${name}.png`) });
    assert.ok(shot.length > 20_000, 'the screenshot shows something');
    await table.close();
  }
  await visit.load();
});
