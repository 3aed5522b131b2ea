// Fails on any include that goes up the house or into a room that a room's CMakeLists.txt does not say it USES.
// usage: node check_layers.mjs REPOSITORY
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

const repository = process.argv[2] ?? '.';
const order = readFileSync(join(repository, 'CMakeLists.txt'), 'utf8').match(/foreach\(room IN ITEMS ([a-z ]+)\)/)[1].split(' ');
const faults = [];
let includes = 0;

for (const room of order) {
  const folder = join(repository, 'engine/croquis', room);
  if (!existsSync(join(folder, 'CMakeLists.txt'))) continue;
  const declaration = readFileSync(join(folder, 'CMakeLists.txt'), 'utf8');
  const uses = (declaration.match(/USES ([a-z \n]+)/)?.[1] ?? '').split(/\s+/).filter(Boolean);
  for (const used of uses) {
    if (!(order.indexOf(used) >= 0 && order.indexOf(used) < order.indexOf(room))) {
      faults.push(`${room}/CMakeLists.txt: uses ${used}, which does not stand before it`);
    }
  }
  for (const file of readdirSync(folder).filter((name) => /\.(h|cpp)$/.test(name))) {
    const text = readFileSync(join(folder, file), 'utf8');
    if (text.includes('__EMSCRIPTEN__')) faults.push(`${room}/${file}: the engine knows no platform`);
    for (const [, other] of text.matchAll(/#include "croquis\/([a-z]+)\//g)) {
      includes += 1;
      if (other !== room && !uses.includes(other)) faults.push(`${room}/${file}: includes ${other}, which ${room} does not use`);
    }
  }
}
if (includes === 0) faults.push('no include found: is this the repository?');
for (const fault of faults) console.error(fault);
console.log(`${includes} includes checked, ${faults.length} faults`);
process.exit(faults.length > 0 ? 1 : 0);
