// SPDX-License-Identifier: MIT
// What the stories share: one server, one browser, a fresh visit each.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { arc, DATA, launch, ROOT, servePage, Visit } from './table.mjs';

/** Where the stories play; there once they have begun. */
export const place = { browser: null, url: '' };
let server;

before(async () => {
  server = await servePage();
  place.url = `http://127.0.0.1:${server.address().port}/`;
  place.browser = await launch();
});

after(async () => {
  await place.browser?.close();
  server?.close();
});

export const story = (name, options, play) =>
  test(name, { timeout: 900_000, skip: options.data && !DATA ? 'the folder of real files is not there' : false }, async () => {
    const visit = await Visit.open(place.browser, place.url, options.context);
    await play(visit);
    await visit.close();
  });

/** A C from the hips over the chest to beside the head: asks the trunk to lean. */
export async function lean(visit, dx = 90) {
  const hips = await visit.pixel('hips');
  const head = await visit.pixel('head');
  return arc(hips, { x: (hips.x + head.x) / 2 + 0.1 * dx, y: (hips.y + head.y) / 2 }, { x: head.x + dx, y: head.y + 12 });
}

/** A file of its own in the build folder. */
export function written(name, bytes) {
  const path = join(ROOT, 'build', name);
  mkdirSync(join(ROOT, 'build'), { recursive: true });
  writeFileSync(path, bytes);
  return path;
}
