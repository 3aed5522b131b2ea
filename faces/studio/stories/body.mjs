// SPDX-License-Identifier: MIT
// The body itself: joints, pins, poses, skinning, whose turn it is.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { story, written } from './play.mjs';
import { arc, distance, ROOT } from './table.mjs';

story('a hand is dragged, a foot is pinned, the pose is mirrored and reset', {}, async (visit) => {
  const rest = await visit.joints();
  await visit.page.keyboard.press('g');
  const hand = await visit.pixel('leftHand');
  await visit.draw(Array.from({ length: 10 }, (_, i) => ({ x: hand.x - 6 * i, y: hand.y - 9 * i })));
  const dragged = await visit.joints();
  assert.ok(distance(rest, dragged) > 0.1, 'the hand moved');
  const actor = (await visit.state()).actors[0].id;
  assert.ok(await visit.run({ name: 'mirror', actor, side: 'both' }));
  const mirrored = await visit.joints();
  assert.ok(distance(dragged, mirrored) > 0.1);
  assert.ok(await visit.run({ name: 'mirror', actor, side: 'both' }));
  assert.ok(distance(dragged, await visit.joints()) < 1e-5, 'mirroring twice gives the pose back');
  assert.ok(await visit.run({ name: 'reset', actor, joints: [], amount: 1 }));
  assert.ok(distance(rest, await visit.joints()) < 1e-6);
});

story('the shelf has poses and hands, and a pose of it is applied by a tap', {}, async (visit) => {
  const shelf = await visit.page.evaluate(() => globalThis.croquis.table.engine.query('shelf', { actor: globalThis.croquis.table.actor.value }));
  assert.ok(shelf.poses.filter((pose) => pose.kind === 'pose').length >= 24);
  assert.ok(shelf.poses.filter((pose) => pose.kind === 'hand').length >= 8);
  const before = await visit.joints();
  await visit.page.locator('.pose-card').nth(4).click();
  await visit.undoSays('pose');
  await visit.settled();
  assert.ok(distance(before, await visit.joints()) > 0.1);
  assert.ok(await visit.run({ name: 'keep_pose', actor: (await visit.state()).actors[0].id, pose_name: 'Mine' }));
  assert.equal((await visit.state()).poses.length, 1);
});

story('a foot is pinned from the bar of its joint, and stays while the hips are dragged', {}, async (visit) => {
  await visit.page.keyboard.press('g');
  await visit.tap(await visit.pixel('leftFoot'));
  await visit.page.locator('.joint-bar button').first().click();
  await visit.undoSays('pin');
  const { actors } = await visit.state();
  assert.equal(actors[0].pins.length, 1);
  const at = async (bone) => {
    const index = actors[0].joints.findIndex((joint) => joint.bone === bone);
    return (await visit.joints()).slice(3 * index, 3 * index + 3);
  };
  const [held, hips] = [await at('leftFoot'), await at('hips')];
  const joint = actors[0].joints.findIndex((j) => j.bone === 'hips');
  assert.ok(await visit.run({ name: 'drag', actor: actors[0].id, joint, target: [hips[0] + 0.1, hips[1] - 0.15, hips[2]] }));
  assert.ok(distance(held, await at('leftFoot')) < 0.01, 'the pinned foot stays');
  assert.ok(distance(hips, await at('hips')) > 0.05, 'the hips went');
});

story('own poses are kept in the browser and as a file; a picture becomes the backdrop', {}, async (visit) => {
  const { page } = visit;
  await page.locator('.tab').nth(2).click();
  await page.locator('.section-body input[type=text]').fill('Bend');
  await page.getByRole('button', { name: 'Keep this pose' }).click();
  await page.waitForFunction(() => JSON.parse(localStorage.getItem('croquis.poses') ?? '[]').length === 1);
  const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save my poses' }).click()]);
  const text = readFileSync(await file.path(), 'utf8');
  await page.getByRole('button', { name: 'Forget pose Bend' }).click();
  await page.waitForFunction(() => JSON.parse(localStorage.getItem('croquis.poses')).length === 0);
  assert.equal((await visit.drop(written('poses.json', text))).kind, 'note');
  assert.equal(await page.evaluate(() => JSON.parse(localStorage.getItem('croquis.poses'))[0].name), 'Bend');
  assert.equal((await visit.drop(written('other.json', '{"poses": 3}'))).kind, 'error');
  const icon = readFileSync(join(ROOT, 'faces/studio/public/icon-192.png')).toString('base64');
  await page.evaluate(async (data) => {
    const blob = await (await fetch(`data:image/png;base64,${data}`)).blob();
    await globalThis.croquis.openFile(new File([blob], 'photo.png', { type: 'image/png' }));
  }, icon);
  assert.match(await page.evaluate(() => document.getElementById('backdrop').style.backgroundImage), /^url\("blob:/);
});

story('a character is taken in hand by a tap, or by a line that starts on it', {}, async (visit) => {
  const { page } = visit;
  const [mannequin] = (await visit.state()).actors;
  await page.evaluate(() => globalThis.croquis.addCharacter('snake'));
  const snake = (await visit.state()).actors.at(-1);
  const [left, right] = [await visit.joints(mannequin.id), await visit.joints(snake.id)].map((joints) => joints.filter((_, i) => i % 3 === 0));
  assert.ok(Math.max(...left) < Math.min(...right), 'the newcomer stands beside the other');
  const inHand = () => page.evaluate(() => globalThis.croquis.table.actor.value);
  assert.equal(await inHand(), snake.id);
  await page.evaluate((id) => globalThis.croquis.stage.frame(id), mannequin.id);
  const at = (id, bone) => page.evaluate(([actor, name]) => {
    const { stage } = globalThis.croquis;
    const view = stage.characters.get(actor);
    const { x, y } = stage.rig.project(view.joint(view.info.joints.findIndex((joint) => joint.bone === name || joint.name === name)));
    return { x, y };
  }, [id, bone]);
  const head = await at(mannequin.id, 'head');
  await page.keyboard.press('q');
  await visit.tap(head);
  assert.equal(await inHand(), mannequin.id);
  assert.deepEqual(await page.evaluate(() => globalThis.croquis.table.picked.value), [], 'the tap did only that');
  await page.evaluate((id) => globalThis.croquis.table.take(id), snake.id);
  await page.keyboard.press('d');
  const hand = await at(mannequin.id, 'leftHand');
  await visit.draw(arc(head, { x: (head.x + hand.x) / 2, y: head.y - 40 }, hand, 12));
  assert.equal(await inHand(), mannequin.id);
  assert.equal((await visit.state()).strokes[0].actor, mannequin.id);
});

story('a joint is rotated about an axis that is held by its key', {}, async (visit) => {
  const { page } = visit;
  await page.keyboard.press('r');
  const elbow = await visit.pixel('leftLowerArm');
  await visit.tap(elbow);
  await page.keyboard.press('y');
  assert.equal(await page.getByRole('button', { name: 'Rotate about Y only' }).getAttribute('aria-pressed'), 'true');
  const before = await visit.joints();
  await visit.draw(Array.from({ length: 8 }, (_, i) => ({ x: elbow.x + 9 * i, y: elbow.y })));
  await visit.undoSays('rotate');
  const after = await visit.joints();
  const heights = before.map((value, i) => (i % 3 === 1 ? Math.abs(value - after[i]) : 0));
  assert.ok(distance(before, after) > 0.01, 'the hand went');
  assert.ok(Math.max(...heights) < 0.25 * distance(before, after), 'about the upright axis');
  await page.keyboard.press('d');
  assert.equal(await page.evaluate(() => globalThis.croquis.axis.value), null);
});

story('the graphics card puts twisted limbs where the engine does, by matrices and by dual quaternions', {}, async (visit) => {
  const actor = (await visit.state()).actors[0];
  await visit.run({ name: 'set_table', settings: { limits: 'none' } });
  for (const bone of ['leftLowerArm', 'rightHand', 'head', 'spine']) {
    const joint = actor.joints.findIndex((j) => j.bone === bone);
    await visit.run({ name: 'rotate', actor: actor.id, joint, rotation_model: [Math.sin(0.9), 0, 0, Math.cos(0.9)] });
  }
  const vertices = (side) =>
    visit.page.evaluate(async ([of, id, parts]) => {
      const { stage, table } = globalThis.croquis;
      const all = [];
      for (let part = 0; part < parts; ++part) all.push(...(of === 'card' ? stage.readVertices(id, part) : await table.engine.vertices(id, part)));
      return all;
    }, [side, actor.id, actor.parts.length]);
  const linear = await vertices('engine');
  assert.ok(distance(await vertices('card'), linear) < 1e-5);
  await visit.page.locator('summary', { hasText: 'View' }).click();
  await visit.page.getByLabel('Limbs keep their volume when twisted').check();
  await visit.settled();
  const dual = await vertices('engine');
  assert.ok(distance(linear, dual) > 0.005, 'they differ');
  assert.ok(distance(await vertices('card'), dual) < 1e-5);
});
