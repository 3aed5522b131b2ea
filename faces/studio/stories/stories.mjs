// SPDX-License-Identifier: MIT
// What a person does at the table, played in a real browser against the built page. Run by `node --test`.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync, mkdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { bigGlb } from './big_glb.mjs';
import { arc, DATA, distance, launch, ROOT, servePage, Visit } from './table.mjs';

const require = createRequire(import.meta.url);
let server;
let browser;
let url;

before(async () => {
  server = await servePage();
  url = `http://127.0.0.1:${server.address().port}/`;
  browser = await launch();
});

after(async () => {
  await browser?.close();
  server?.close();
});

/** A C from the hips over the chest to beside the head: asks the trunk to lean. */
async function lean(visit, dx = 90) {
  const hips = await visit.pixel('hips');
  const head = await visit.pixel('head');
  return arc(hips, { x: (hips.x + head.x) / 2 + 0.1 * dx, y: (hips.y + head.y) / 2 }, { x: head.x + dx, y: head.y + 12 });
}

const story = (name, options, play) =>
  test(name, { timeout: 900_000, skip: options.data && !DATA ? 'the folder of real files is not there' : false }, async () => {
    const visit = await Visit.open(browser, url, options.context);
    await play(visit);
    await visit.close();
  });

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

function written(name, bytes) {
  const path = join(ROOT, 'build', name);
  mkdirSync(join(ROOT, 'build'), { recursive: true });
  writeFileSync(path, bytes);
  return path;
}

/** A file that begins like a GLB and goes on as nothing. */
const brokenFile = () => written('broken.glb', Buffer.concat([Buffer.from('glTF'), Buffer.alloc(30, 7)]));

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

story('a character is taken in hand by a tap, or by a line that starts on it', {}, async (visit) => {
  const { page } = visit;
  const [mannequin] = (await visit.state()).actors;
  await page.evaluate(() => globalThis.croquis.addCharacter('snake'));
  const snake = (await visit.state()).actors.at(-1);
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

story('a tab that is killed gives back the project with its history', {}, async (visit) => {
  await visit.draw(await lean(visit));
  await visit.draw(await lean(visit, -70));
  const posed = await visit.joints();
  const { strokes } = await visit.state();
  await visit.written(3); // the mannequin and two lines
  visit.wire.send('Page.crash').catch(() => {}); // it never answers
  await visit.page.waitForEvent('crash');
  await visit.page.close({ runBeforeUnload: false });
  await visit.load();
  assert.ok(distance(posed, await visit.joints()) < 1e-6, 'the pose is back');
  assert.equal((await visit.state()).strokes.length, strokes.length);
  await visit.page.keyboard.press('Control+z');
  await visit.page.keyboard.press('Control+z');
  await visit.until(() => globalThis.croquis.table.state.value.strokes.length === 0); // and can be undone
});

story('a later visit starts from where the project was kept, and undo reaches the steps before', {}, async (visit) => {
  await visit.draw(await lean(visit));
  await visit.page.evaluate(() => globalThis.croquis.table.keepCheckpoint());
  await visit.run({ name: 'reset', actor: (await visit.state()).actors[0].id, joints: [], amount: 0.5 });
  const posed = await visit.joints();
  await visit.written(3); // the mannequin, the line, half a reset
  await visit.page.reload();
  await visit.ready();
  assert.equal(await visit.page.evaluate(() => globalThis.croquis.table.earlier.value), true);
  assert.ok(distance(posed, await visit.joints()) < 1e-6);
  await visit.page.keyboard.press('Control+z');
  await visit.undoSays('');
  await visit.page.getByRole('button', { name: 'Undo' }).click();
  await visit.undoSays('add mannequin');
  assert.equal((await visit.state()).strokes.length, 0, 'the line is undone, though it was drawn before');
  await visit.page.keyboard.press('Control+y');
  await visit.undoSays('draw');
});

story('a second tab leaves the journal of the first alone', {}, async (visit) => {
  const second = new Visit(visit.context, url);
  await second.load();
  assert.ok(await second.run({ name: 'reset', actor: (await second.state()).actors[0].id, joints: [], amount: 1 }));
  await second.page.close();
  await visit.page.reload();
  await visit.ready();
  assert.notEqual((await visit.state()).undo, 'reset');
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

test('the page works with the network off', { timeout: 900_000 }, async () => {
  const own = await servePage();
  const visit = await Visit.open(browser, `http://127.0.0.1:${own.address().port}/`);
  await visit.page.evaluate(() => navigator.serviceWorker.ready.then(() => true));
  await visit.page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  own.closeAllConnections?.();
  own.close();
  await visit.context.setOffline(true);
  await visit.page.reload();
  await visit.ready();
  await visit.draw(await lean(visit));
  assert.equal((await visit.state()).strokes.length, 1);
  await visit.close();
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
    const table = new Visit(await browser.newContext({ viewport: { width, height } }), url);
    await table.load('');
    const { poses } = await table.page.evaluate(() => globalThis.croquis.table.engine.query('shelf', { actor: globalThis.croquis.table.actor.value }));
    const { pose } = poses.find(({ name }) => name === 'Walk');
    await table.run({ name: 'apply_pose', actor: (await table.state()).actors[0].id, pose, strength: 1, flipped: false });
    const [foot, head] = [await table.pixel('rightFoot'), await table.pixel('head')];
    const tall = foot.y - head.y;
    await table.draw(arc(foot, { x: foot.x, y: foot.y - 0.6 * tall }, { x: foot.x + 0.4 * tall, y: foot.y - 1.15 * tall }, 40));
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
