// SPDX-License-Identifier: MIT
// Lines: drawing, reading, changing them, with pen and fingers.
import assert from 'node:assert/strict';
import { bigGlb } from './big_glb.mjs';
import { lean, story, written } from './play.mjs';
import { arc, distance } from './table.mjs';

story('a pen draws a line: the joints follow while it moves, and one undo restores', {}, async (visit) => {
  const before = await visit.joints();
  let during;
  await visit.draw(await lean(visit), async () => {
    await visit.moved(before, 0.02);
    await visit.settled(); // the newest preview is shown
    during = await visit.joints();
  });
  assert.ok(distance(before, during) > 0.02, 'the body moved while the pen was down');
  const state = await visit.state();
  assert.equal(state.strokes.length, 1);
  const pressures = state.strokes[0].samples.map((sample) => sample[3]);
  assert.ok(Math.max(...pressures) - Math.min(...pressures) > 0.3, 'the pressure of the pen is kept');
  const after = await visit.joints();
  assert.ok(distance(after, during) < 0.02, 'lifting the pen changes next to nothing');
  await visit.page.keyboard.press('Control+z');
  await visit.until(() => globalThis.croquis.table.state.value.strokes.length === 0);
  await visit.settled();
  assert.ok(distance(before, await visit.joints()) < 1e-6, 'undo restores the pose');
  await visit.page.keyboard.press('Control+Shift+Z');
  await visit.undoSays('draw');
  await visit.settled();
  assert.ok(distance(after, await visit.joints()) < 1e-6, 'redo brings it back');
});

story('the readings of a line can be cycled, the body following', {}, async (visit) => {
  await visit.draw(await lean(visit));
  const first = await visit.joints();
  const count = await visit.page.evaluate(() => globalThis.croquis.table.solved.value.alternatives.length);
  assert.ok(count > 1, 'there is more than one reading');
  const chosen = (wanted) => visit.until((alternative) => globalThis.croquis.table.state.value.strokes[0].settings.alternative === alternative, wanted);
  await visit.page.keyboard.press(']');
  await chosen(1);
  await visit.settled();
  assert.ok(distance(first, await visit.joints()) > 1e-3, 'another reading is another pose');
  await visit.page.keyboard.press('[');
  await chosen(0);
  await visit.settled();
  assert.ok(distance(first, await visit.joints()) < 1e-6, 'and back');
});

story('orbiting moves the camera alone, and the stroke stays anchored in its view', {}, async (visit) => {
  await visit.draw(await lean(visit));
  const before = await visit.joints();
  const { camera, samples } = (await visit.state()).strokes[0];
  await visit.page.mouse.move(300, 320);
  await visit.page.mouse.down({ button: 'right' });
  await visit.page.mouse.move(420, 340, { steps: 4 });
  await visit.page.mouse.up({ button: 'right' });
  const state = await visit.state();
  assert.equal(state.strokes.length, 1);
  assert.deepEqual(state.strokes[0].camera, camera);
  assert.deepEqual(state.strokes[0].samples, samples);
  assert.ok(distance(before, await visit.joints()) < 1e-9);
  const turned = await visit.page.evaluate(() => globalThis.croquis.stage.rig.toSpec());
  assert.ok(distance(turned.position, camera.position) > 0.1, 'the camera has moved');
  await visit.page.keyboard.press('0');
  const back = await visit.page.evaluate(() => globalThis.croquis.stage.rig.toSpec());
  assert.ok(distance(back.position, camera.position) < 1e-6, 'and finds its way back to the view of the stroke');
});

story('a line can be redrawn by its points, exaggerated, hidden and deleted', {}, async (visit) => {
  await visit.draw(await lean(visit));
  const drawn = await visit.joints();
  const { samples, id } = (await visit.state()).strokes[0];
  const end = samples.at(-1);
  await visit.draw(Array.from({ length: 8 }, (_, i) => ({ x: end[0] - 9 * i, y: end[1] })));
  const state = await visit.state();
  assert.equal(state.strokes.length, 1, 'the line was changed, no new one drawn');
  assert.equal(state.strokes[0].id, id);
  assert.ok(distance(drawn, await visit.joints()) > 0.01, 'the body followed its line');
  assert.ok(await visit.run({ name: 'set_stroke', stroke: id, settings: { exaggerate: 1.6 } }));
  assert.ok(await visit.run({ name: 'set_stroke', stroke: id, settings: {}, hidden: true }));
  assert.equal((await visit.state()).strokes[0].hidden, true);
  assert.ok(await visit.run({ name: 'delete_stroke', stroke: id }));
  assert.equal((await visit.state()).strokes.length, 0);
});

story('a character of 100,000 vertices follows the pen, with one upload a pose', {}, async (visit) => {
  const toast = await visit.drop(written('big.glb', bigGlb(100_000)));
  assert.equal(toast.kind, 'note', toast.text);
  const state = await visit.state();
  const big = state.actors.at(-1);
  assert.ok(big.parts[0].vertices >= 100_000);
  await visit.run({ name: 'remove_actor', actor: state.actors[0].id });
  await visit.page.evaluate(() => globalThis.croquis.frameSelected());
  const before = await visit.joints(big.id);
  const uploads = () => visit.page.evaluate((id) => globalThis.croquis.stage.characters.get(id).palette.uploads, big.id);
  const [foot, top] = [await visit.pixel('bone0'), await visit.pixel('bone5')];
  const uploadsBefore = await uploads();
  await visit.draw(arc(foot, { x: foot.x - 60, y: (foot.y + top.y) / 2 }, { x: top.x + 70, y: top.y + 20 }, 12));
  assert.ok(distance(before, await visit.joints(big.id)) > 0.05, 'it took the pose');
  const previews = await visit.page.evaluate(() => globalThis.croquis.table.timings.length);
  assert.ok((await uploads()) - uploadsBefore <= previews + 2, 'one palette upload for each pose shown');
  assert.ok((await visit.page.evaluate(() => globalThis.croquis.stage.stats.drawCalls)) < 20);
});

story('joints are picked by hand, and a selection that is no line is told of', {}, async (visit) => {
  const tap = async (name) => visit.tap(await visit.pixel(name));
  const told = (test) => visit.until(test);
  await visit.page.keyboard.press('q');
  for (const bone of ['leftUpperArm', 'leftLowerArm', 'leftHand']) await tap(bone);
  await told(() => globalThis.croquis.table.segments.value.length > 0);
  assert.equal(await visit.page.evaluate(() => globalThis.croquis.table.pickedFault.value), '');
  const picked = await visit.page.evaluate(() => globalThis.croquis.table.picked.value);
  await visit.page.keyboard.press('d');
  const [shoulder, hand] = [await visit.pixel('leftUpperArm'), await visit.pixel('leftHand')];
  await visit.draw(arc(shoulder, { x: (shoulder.x + hand.x) / 2, y: shoulder.y - 50 }, { x: hand.x - 20, y: hand.y - 90 }, 12));
  assert.deepEqual((await visit.state()).strokes[0].line.joints, picked, 'the line is that of the joints picked');
  await visit.page.keyboard.press('q');
  await tap('rightFoot');
  await told(() => globalThis.croquis.table.pickedFault.value !== '');
  assert.ok(await visit.page.locator('.fault').isVisible(), 'a clear word where it is no line');
});

story('an upright drawing plane is refused in words when it is seen from straight above', {}, async (visit) => {
  const { page } = visit;
  await page.locator('summary', { hasText: 'Advanced' }).click();
  await page.getByLabel('Method').selectOption('rotation');
  await page.getByLabel('Drawing plane').selectOption('ground');
  await page.keyboard.press('Escape');
  await page.locator('#table').focus();
  await page.keyboard.press('7');
  const [hips, hand] = [await visit.pixel('hips'), await visit.pixel('leftHand')];
  await visit.draw(arc(hips, { x: (hips.x + hand.x) / 2, y: hips.y - 30 }, hand, 8));
  assert.equal((await visit.state()).strokes.length, 0);
  await page.getByRole('alert').filter({ hasText: 'upright plane' }).waitFor();
  await page.keyboard.press('1');
  await visit.draw(await lean(visit));
  assert.equal((await visit.state()).strokes.length, 1, 'seen from the front it serves');
});

story('fingers: one draws, two navigate, a tap of two undoes, of three redoes', { context: { hasTouch: true } }, async (visit) => {
  const hips = await visit.pixel('hips');
  const head = await visit.pixel('head');
  await visit.wire.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ ...hips, id: 0 }] });
  for (const p of arc(hips, { x: hips.x + 10, y: (hips.y + head.y) / 2 }, { x: head.x + 80, y: head.y })) {
    await visit.wire.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: [{ ...p, id: 0 }] });
  }
  await visit.lifted(1, () => visit.wire.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] }));
  assert.equal((await visit.state()).strokes.length, 1, 'one finger drew');
  const before = await visit.page.evaluate(() => globalThis.croquis.stage.rig.state.height);
  await visit.fingers(2, async (move) => {
    for (let i = 1; i <= 6; ++i) await move(3 * i, 2 * i, 9 * i);
  });
  assert.equal((await visit.state()).strokes.length, 1, 'two fingers drew nothing');
  assert.ok((await visit.page.evaluate(() => globalThis.croquis.stage.rig.state.height)) < before, 'they zoomed in');
  await visit.fingers(2);
  assert.equal((await visit.state()).strokes.length, 0, 'a tap of two undid');
  await visit.fingers(3);
  assert.equal((await visit.state()).strokes.length, 1, 'a tap of three redid');
});
