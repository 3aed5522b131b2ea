// SPDX-License-Identifier: MIT
// What outlives the tab, and the network.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { lean, place, story } from './play.mjs';
import { distance, servePage, Visit } from './table.mjs';

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
  const second = new Visit(visit.context, place.url);
  await second.load();
  assert.ok(await second.run({ name: 'reset', actor: (await second.state()).actors[0].id, joints: [], amount: 1 }));
  await second.page.close();
  await visit.page.reload();
  await visit.ready();
  assert.notEqual((await visit.state()).undo, 'reset');
});

test('the page works with the network off', { timeout: 900_000 }, async () => {
  const own = await servePage();
  const visit = await Visit.open(place.browser, `http://127.0.0.1:${own.address().port}/`);
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
