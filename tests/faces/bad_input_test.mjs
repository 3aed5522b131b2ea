// Files that are wrong: every malformed file of the shared data, and a good file cut off anywhere, ends in status 2 with
// one line, or in 0 where the file is readable in truth; in bounded time and memory; never with an output half written.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import test from 'node:test';
import { croquis, dataPath, faultOf, makeFolder, repository, sanitized, succeed } from './support.mjs';

function filesUnder(folder) {
  return readdirSync(folder).sort().flatMap((name) => {
    const path = join(folder, name);
    return statSync(path).isDirectory() ? filesUnder(path) : [path];
  });
}
const readable = new Set(['.gltf', '.glb', '.vrm', '.bvh', '.obj']);
const malformed = dataPath('malformed');
const seconds = sanitized ? 120 : 20;
const line = '<svg viewBox="0 0 1024 1024"><path d="M512 900 C 300 700 300 400 560 120"/></svg>';

const kinds = malformed ? readdirSync(malformed).sort() : [];
test('the malformed files are there', { skip: malformed ? false : 'no shared data' }, () => assert.ok(kinds.length >= 5));
for (const kind of kinds) {
  const files = filesUnder(join(malformed, kind)).filter((file) => readable.has(extname(file)));
  test(`info bears every malformed file of ${kind}`, { skip: files.length === 0 && 'no format that is read' }, () => {
    const faults = [];
    for (const file of files) {
      const fault = faultOf(croquis(['info', file], { seconds }));
      if (fault) faults.push(`${file}: ${fault}`);
    }
    assert.deepEqual(faults, []);
  });
  test(`pose bears every malformed file of ${kind} and leaves the old output`, { skip: files.length === 0 && 'no format that is read' }, () => {
    const folder = makeFolder(), faults = [];
    writeFileSync(join(folder, 'line.svg'), line);
    for (const file of files) {
      writeFileSync(join(folder, 'out.glb'), 'old');
      const run = croquis(['pose', file, '--line', 'line.svg', '-o', 'out.glb'], { cwd: folder });
      const fault = faultOf(run);
      if (fault) faults.push(`${file}: ${fault}`);
      if (run.status !== 0 && readFileSync(join(folder, 'out.glb'), 'utf8') !== 'old') faults.push(`${file}: the old output is lost`);
      const left = readdirSync(folder).filter((name) => !['line.svg', 'out.glb'].includes(name));
      if (left.length > 0) faults.push(`${file}: left ${left}`);
    }
    assert.deepEqual(faults, []);
  });
}

/** About fifty places to cut a file at: all of the first bytes, then evenly. */
function cuts(length) {
  const places = new Set([0, 1, 2, 3, 4, 8, 11, 12, 15, 19, 20, 21, length - 1, length - 2, length - 4]);
  for (let i = 1; i < 40; ++i) places.add(Math.floor((i * length) / 40));
  return [...places].filter((cut) => cut >= 0 && cut < length);
}
const corpus = join(repository, 'tests/fuzz/corpus');
const good = ['gltf/skinned.glb', 'gltf/skinned.gltf', 'gltf/humanoid.vrm.gltf', 'bvh/arm.bvh'];
for (const name of good) {
  test(`info bears ${name} cut off anywhere`, () => {
    const folder = makeFolder(), whole = readFileSync(join(corpus, name)), file = join(folder, `cut${extname(name)}`), faults = [];
    writeFileSync(file, whole);
    succeed(['info', file]);
    for (const cut of cuts(whole.length)) {
      writeFileSync(file, whole.subarray(0, cut));
      const fault = faultOf(croquis(['info', file], { seconds }));
      if (fault) faults.push(`cut at ${cut}: ${fault}`);
    }
    assert.deepEqual(faults, []);
  });
}

test('a built-in character cut off anywhere is refused, as a project too', () => {
  const folder = makeFolder();
  for (const name of ['snake.glb', 'snake.croquis']) {
    succeed(['character', 'snake', '-o', name], { cwd: folder });
    const whole = readFileSync(join(folder, name)), faults = [];
    for (const cut of cuts(whole.length)) {
      writeFileSync(join(folder, `cut-${name}`), whole.subarray(0, cut));
      const fault = faultOf(croquis(['info', `cut-${name}`], { cwd: folder }), [2]);
      if (fault) faults.push(`${name} cut at ${cut}: ${fault}`);
    }
    assert.deepEqual(faults, []);
  }
});

test('lines and cameras cut off anywhere are borne', () => {
  const folder = makeFolder(), faults = [];
  const camera = '{"projection":"orthographic","height":2.2,"position":[0,0.9,5],"target":[0,0.9,0],"up":[0,1,0],"width":64,"height_px":64}';
  const bvh = join(corpus, 'bvh/arm.bvh');
  writeFileSync(join(folder, 'line.svg'), line);
  for (let cut = 0; cut < line.length; cut += 3) {
    writeFileSync(join(folder, 'cut.svg'), line.slice(0, cut));
    const fault = faultOf(croquis(['pose', bvh, '--line', 'cut.svg', '-o', 'out.bvh'], { cwd: folder }));
    if (fault) faults.push(`line cut at ${cut}: ${fault}`);
  }
  for (let cut = 0; cut < camera.length; cut += 5) {
    writeFileSync(join(folder, 'cut.json'), camera.slice(0, cut));
    const fault = faultOf(croquis(['pose', bvh, '--line', 'line.svg', '--camera', 'cut.json', '-o', 'out.bvh'], { cwd: folder }), [2]);
    if (fault) faults.push(`camera cut at ${cut}: ${fault}`);
  }
  assert.deepEqual(faults, []);
});

const hurtful = {
  'a rig of one joint': 'HIERARCHY\nROOT only\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n0 0 0\n',
  'no frames': 'HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nJOINT b\n{\nOFFSET 0 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n}\n}\nMOTION\nFrames: 0\nFrame Time: 0.1\n',
  'one frame more than announced': `HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nJOINT b\n{\nOFFSET 0 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n}\n}\nMOTION\nFrames: 3069\nFrame Time: 0.1\n${'1 2 3 4 5 6\n'.repeat(3070)}`,
  'bones without length': 'HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nJOINT b\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 0 0\n}\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n0 0 0 0 0 0\n',
  'frames that are said to be very many': 'HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n}\nMOTION\nFrames: 2000000000\nFrame Time: 0.1\n0 0 0\n',
};
for (const [what, text] of Object.entries(hurtful)) {
  test(`${what} in a BVH`, () => {
    const folder = makeFolder();
    writeFileSync(join(folder, 'rig.bvh'), text);
    writeFileSync(join(folder, 'line.svg'), line);
    for (const args of [['info', 'rig.bvh'], ['pose', 'rig.bvh', '--line', 'line.svg', '-o', 'out.glb'],
      ['pose', 'rig.bvh', '--start', 'rig.bvh:0', '-o', 'out.bvh'], ['render', 'rig.bvh', '-o', 'out.png', '--size', '64x64']]) {
      assert.equal(faultOf(croquis(args, { cwd: folder })), undefined, args.join(' '));
    }
  });
}
