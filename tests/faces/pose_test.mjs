// Posing, drawing, converting and describing the built-in characters, from the arguments to the files.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { boneLengths, croquis, faultOf, gltfJson, hasValidator, makeFolder, readPng, succeed, validatorErrors } from './support.mjs';

const curve = 'M512 930 C 300 760 330 420 520 120';
function folderWithLine(path = curve, name = 'line.svg') {
  const folder = makeFolder();
  writeFileSync(join(folder, name), `<svg viewBox="0 0 1024 1024"><path id="flow" d="${path}"/></svg>`);
  return folder;
}
const posed = (folder, ...args) => JSON.parse(succeed(['pose', 'mannequin', '--line', 'line.svg', '--json', ...args], { cwd: folder }));

/** How many pixels of two pictures of one size differ visibly. */
function differing(a, b) {
  let count = 0;
  for (let i = 0; i < a.pixels.length; i += a.channels) {
    if ([0, 1, 2].some((c) => Math.abs(a.pixels[i + c] - b.pixels[i + c]) > 8)) ++count;
  }
  return count;
}

test('a line poses the mannequin: file, picture and report', async () => {
  const folder = folderWithLine();
  const report = posed(folder, '-o', 'out.glb', '--picture', 'out.png');
  assert.equal(report.status, 'ok');
  assert.equal(report.body_line, 'trunk');
  assert.ok(['forward', 'backward'].includes(report.direction));
  assert.ok(report.fit.mean_px >= 0 && report.fit.max_px >= report.fit.mean_px && report.fit.tangent_deg >= 0);
  assert.ok(report.bone_length_drift < 1e-9);
  assert.ok(Array.isArray(report.limit_violations) && Array.isArray(report.alternatives));
  assert.ok(report.solve_ms > 0 && report.solve_ms < 1000);
  const picture = readPng(join(folder, 'out.png'));
  assert.deepEqual([picture.width, picture.height, picture.depth], [1024, 1024, 8]);
  assert.ok([2, 6].includes(picture.colour));
  if (hasValidator) assert.deepEqual(await validatorErrors(join(folder, 'out.glb')), []);
});

test('the pose is in the file: joints turned, bones as long as before', () => {
  const folder = folderWithLine();
  succeed(['character', 'mannequin', '-o', 'rest.glb'], { cwd: folder });
  posed(folder, '-o', 'out.glb');
  const before = gltfJson(join(folder, 'rest.glb')), after = gltfJson(join(folder, 'out.glb'));
  const a = boneLengths(before), b = boneLengths(after);
  assert.deepEqual(Object.keys(a), Object.keys(b));
  for (const i of Object.keys(a)) assert.ok(Math.abs(a[i] - b[i]) <= 1e-6 * Math.max(a[i], 0.01), before.nodes[i].name);
  const turned = before.nodes.filter((node, i) =>
    JSON.stringify(node.rotation ?? [0, 0, 0, 1]) !== JSON.stringify(after.nodes[i].rotation ?? [0, 0, 0, 1]));
  assert.ok(turned.length >= 3, 'the trunk has more than three joints');
});

test('the same command writes the same bytes', () => {
  const folder = folderWithLine();
  posed(folder, '-o', 'one.glb', '--picture', 'one.png');
  posed(folder, '-o', 'two.glb', '--picture', 'two.png');
  assert.ok(readFileSync(join(folder, 'one.glb')).equals(readFileSync(join(folder, 'two.glb'))));
  assert.ok(readFileSync(join(folder, 'one.png')).equals(readFileSync(join(folder, 'two.png'))));
});

test('without a line the start pose is written, and the report has no fit', () => {
  const folder = makeFolder();
  const report = JSON.parse(succeed(['pose', 'cat', '-o', 'cat.glb', '--json'], { cwd: folder }));
  assert.equal(report.fit, null);
  assert.ok(existsSync(join(folder, 'cat.glb')));
});

test('without --json the report is text for people', () => {
  const folder = folderWithLine();
  const text = succeed(['pose', 'mannequin', '--line', 'line.svg', '-o', 'out.glb'], { cwd: folder });
  assert.match(text, /^Posed trunk, /);
  assert.match(text, /Wrote out\.glb\n$/);
});

for (const name of ['mannequin', 'cat', 'snake', 'tree']) {
  test(`the ${name} takes a line along each of its body lines`, () => {
    const folder = folderWithLine();
    const lines = JSON.parse(succeed(['info', name, '--json'], { cwd: folder })).body_lines;
    assert.ok(lines.length > 0);
    for (const line of lines.slice(0, 4)) {
      const report = JSON.parse(succeed(['pose', name, '--line', 'line.svg', '--body-line', line.name, '--json', '-o', 'out.glb'], { cwd: folder }));
      assert.equal(report.body_line, line.name);
      assert.ok(report.bone_length_drift < 1e-9);
    }
  });
}

for (const method of ['rotation', 'rotation-index', 'near', 'curvilinear']) {
  test(`the method ${method} says truly whether it stretches`, () => {
    const report = posed(folderWithLine(), '--method', method, '-o', 'out.glb');
    if (method.startsWith('rotation')) {
      assert.ok(report.bone_length_drift < 1e-9);
    } else {
      assert.ok(report.bone_length_drift > 1e-3);
      assert.match(report.status, /stretched/);
    }
  });
}

test('the line starts at the first joint named when it is drawn forward', () => {
  const folder = folderWithLine();
  const up = posed(folder, '--joints', 'hips,head', '--direction', 'forward', '-o', 'a.glb');
  const down = posed(folder, '--joints', 'hips,head', '--direction', 'backward', '-o', 'b.glb');
  assert.equal(up.direction, 'forward');
  assert.equal(down.direction, 'backward');
  assert.notDeepEqual(gltfJson(join(folder, 'a.glb')).nodes, gltfJson(join(folder, 'b.glb')).nodes);
});

test('a path may climb, pass the root and descend', () => {
  const report = posed(folderWithLine('M300 300 C 400 200 600 200 720 300'), '--joints', 'leftHand,rightHand', '-o', 'out.glb');
  assert.equal(report.body_line, 'leftHand,rightHand');
});

for (const view of ['front', 'back', 'left', 'right', 'top', 'three-quarter']) {
  test(`the view ${view} poses and draws`, () => {
    const folder = folderWithLine();
    posed(folder, '--view', view, '-o', 'out.glb', '--picture', 'out.png', '--size', '320x240');
    const picture = readPng(join(folder, 'out.png'));
    assert.deepEqual([picture.width, picture.height], [320, 240]);
  });
}

test('a camera file gives view and size', () => {
  const folder = folderWithLine('M256 460 C 150 380 160 200 260 60');
  for (const projection of ['{"projection":"orthographic","height":2.2', '{"projection":"perspective","fov_degrees":27']) {
    writeFileSync(join(folder, 'camera.json'),
      `${projection},"position":[0,0.9,5],"target":[0,0.9,0],"up":[0,1,0],"width":512,"height_px":512}`);
    posed(folder, '--camera', 'camera.json', '-o', 'out.glb', '--picture', 'out.png');
    assert.equal(readPng(join(folder, 'out.png')).width, 512);
  }
});

test('the line is drawn into the picture', () => {
  const folder = folderWithLine();
  posed(folder, '-o', 'out.glb', '--picture', 'with.png');
  succeed(['render', 'out.glb', '-o', 'without.png'], { cwd: folder });
  const picture = readPng(join(folder, 'with.png'));
  // Halfway along the curve, by de Casteljau: the ink lies there.
  const [x, y] = [(512 + 3 * 300 + 3 * 330 + 520) / 8, (930 + 3 * 760 + 3 * 420 + 120) / 8].map(Math.round);
  const at = (px, py) => [...picture.pixels.subarray((py * picture.width + px) * picture.channels, (py * picture.width + px) * picture.channels + 3)];
  const distance = Math.hypot(...at(x, y).map((v, i) => v - at(30, 30)[i]));
  assert.ok(distance > 60, `ink ${at(x, y)} on paper ${at(30, 30)}`);
});

test('--as pose, clip and baked each write what they say', async () => {
  const folder = folderWithLine();
  succeed(['character', 'mannequin', '-o', 'rest.glb'], { cwd: folder });
  const rest = gltfJson(join(folder, 'rest.glb'));
  for (const form of ['pose', 'clip', 'baked']) {
    posed(folder, '--as', form, '-o', `${form}.glb`);
    if (hasValidator) assert.deepEqual(await validatorErrors(join(folder, `${form}.glb`)), [], form);
  }
  const pose = gltfJson(join(folder, 'pose.glb')), clip = gltfJson(join(folder, 'clip.glb')), baked = gltfJson(join(folder, 'baked.glb'));
  assert.notDeepEqual(pose.nodes, rest.nodes);
  assert.equal((pose.animations ?? []).length, (rest.animations ?? []).length);
  assert.equal(clip.animations.length, (rest.animations ?? []).length + 1);
  assert.ok(!baked.skins?.length || baked.nodes.every((node) => node.skin === undefined));
});

test('--as clip shows the pose in frame 0', () => {
  const folder = folderWithLine();
  posed(folder, '--as', 'clip', '-o', 'clip.glb');
  posed(folder, '-o', 'pose.glb');
  const camera = '{"projection":"orthographic","height":2.2,"position":[0,0.9,5],"target":[0,0.9,0],"up":[0,1,0],"width":300,"height_px":300}';
  writeFileSync(join(folder, 'camera.json'), camera);
  succeed(['render', 'clip.glb', '--frame', '0', '--camera', 'camera.json', '-o', 'clip.png'], { cwd: folder });
  succeed(['render', 'pose.glb', '--camera', 'camera.json', '-o', 'pose.png'], { cwd: folder });
  succeed(['render', 'mannequin', '--camera', 'camera.json', '-o', 'rest.png'], { cwd: folder });
  const [clip, pose, rest] = ['clip', 'pose', 'rest'].map((name) => readPng(join(folder, `${name}.png`)));
  assert.ok(differing(clip, pose) < 30, `${differing(clip, pose)} pixels differ`);
  assert.ok(differing(clip, rest) > 500, `${differing(clip, rest)} pixels differ`);
});

test('a posed file is a start: frame 0 of its clip stands as the pose did', () => {
  const folder = folderWithLine();
  posed(folder, '--as', 'clip', '-o', 'clip.glb');
  posed(folder, '-o', 'pose.glb');
  succeed(['pose', 'mannequin', '--start', 'clip.glb:0', '-o', 'again.glb'], { cwd: folder });
  const wanted = gltfJson(join(folder, 'pose.glb')).nodes, again = gltfJson(join(folder, 'again.glb')).nodes;
  wanted.forEach((node, i) => (node.rotation ?? [0, 0, 0, 1]).forEach((v, k) =>
    assert.ok(Math.abs(v - (again[i].rotation ?? [0, 0, 0, 1])[k]) < 1e-6, node.name)));
});

test('BVH out: one frame, nine digits, and it is a start again', () => {
  const folder = folderWithLine();
  posed(folder, '-o', 'one.bvh');
  const text = readFileSync(join(folder, 'one.bvh'), 'utf8');
  assert.match(text, /Frames:\s*1\s/);
  assert.match(text, /\d\.\d{7,}/);
  const description = JSON.parse(succeed(['info', 'one.bvh', '--json'], { cwd: folder }));
  assert.equal(description.clips[0].frames, 1);
  succeed(['pose', 'one.bvh', '--start', 'one.bvh:0', '-o', 'two.bvh'], { cwd: folder });
  assert.equal(readFileSync(join(folder, 'two.bvh'), 'utf8'), text);
});

test('stretched bones go into a BVH with --add-positions', () => {
  const folder = folderWithLine();
  posed(folder, '--method', 'curvilinear', '--add-positions', '-o', 'out.bvh');
  assert.ok((readFileSync(join(folder, 'out.bvh'), 'utf8').match(/CHANNELS 6/g) ?? []).length > 1);
});

test('a project keeps pose and stroke, and any program opens it as GLB', async () => {
  const folder = folderWithLine();
  posed(folder, '-o', 'table.croquis');
  posed(folder, '-o', 'pose.glb');
  const description = JSON.parse(succeed(['info', 'table.croquis', '--json'], { cwd: folder }));
  assert.equal(description.strokes, 1);
  succeed(['convert', 'table.croquis', 'again.glb'], { cwd: folder });
  const wanted = gltfJson(join(folder, 'pose.glb')).nodes, again = gltfJson(join(folder, 'again.glb')).nodes;
  wanted.forEach((node, i) => (node.rotation ?? [0, 0, 0, 1]).forEach((v, k) =>
    assert.ok(Math.abs(v - (again[i].rotation ?? [0, 0, 0, 1])[k]) < 1e-6, node.name)));
  if (hasValidator) assert.deepEqual(await validatorErrors(join(folder, 'table.croquis')), []);
});

test('every written format is read again with the same joints', () => {
  const folder = makeFolder();
  const joints = (file) => JSON.parse(succeed(['info', file, '--json'], { cwd: folder })).joints.filter((j) => !j.helper).map((j) => j.name);
  const wanted = joints('mannequin');
  for (const format of ['glb', 'gltf', 'croquis', 'bvh']) {
    succeed(['convert', 'mannequin', `out.${format}`], { cwd: folder });
    const got = joints(`out.${format}`);
    for (const name of wanted) assert.ok(got.includes(name), `${name} is not in ${format}: ${got}`);
  }
});

test('a .gltf brings its companions and is read from another folder', () => {
  const folder = makeFolder();
  succeed(['convert', 'snake', 'out.gltf'], { cwd: folder });
  assert.ok(readdirSync(folder).length >= 1);
  assert.ok(JSON.parse(succeed(['info', join(folder, 'out.gltf'), '--json'])).meshes[0].vertices > 100);
});

test('names of any alphabet go in and out', () => {
  const folder = folderWithLine(curve, 'línea 線.svg');
  writeFileSync(join(folder, 'Хвост.bvh'), `HIERARCHY\nROOT 腰\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\nJOINT tête, haute\n{\nOFFSET 0 10 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 10 0\n}\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n0 0 0 0 0 0 0 0 0\n`);
  const report = JSON.parse(succeed(['pose', 'Хвост.bvh', '--line', 'línea 線.svg', '--joints', '腰,#1', '--json', '-o', '出力.bvh'], { cwd: folder }));
  assert.equal(report.body_line, '腰,#1');
  assert.match(readFileSync(join(folder, '出力.bvh'), 'utf8'), /JOINT tête, haute/);
  assert.match(succeed(['info', 'Хвост.bvh'], { cwd: folder }), /tête, haute/);
});

test('info says everything, as text and as JSON', () => {
  const text = succeed(['info', 'mannequin']);
  for (const part of ['Joints', 'Body lines', 'trunk', 'left_foot-head', 'Humanoid', 'leftUpperArm', 'Meshes', 'Clips']) assert.ok(text.includes(part), part);
  const json = JSON.parse(succeed(['info', 'mannequin', '--json']));
  assert.ok(json.humanoid.hips.confidence > 0.9);
  assert.ok(json.meshes[0].vertices > 5000);
  assert.deepEqual(json.oddities, []);
});

test('proportions change the character', () => {
  const height = (...args) => {
    const folder = makeFolder();
    succeed(['character', 'mannequin', ...args, '-o', 'm.glb'], { cwd: folder });
    const { humanoid, joints } = JSON.parse(succeed(['info', 'm.glb', '--json'], { cwd: folder }));
    const y = (bone) => joints.find((j) => j.name === humanoid[bone].joint).rest_position[1];
    return y('leftUpperLeg') - y('leftFoot');
  };
  assert.ok(height('--limbs', '1.3') > 1.15 * height());
});

test('render: size, transparency, skeleton and both skinnings', () => {
  const folder = folderWithLine();
  posed(folder, '-o', 'out.glb');
  const draw = (name, ...args) => {
    succeed(['render', 'out.glb', '--size', '300x200', '-o', name, ...args], { cwd: folder });
    return readPng(join(folder, name));
  };
  const plain = draw('plain.png'), bones = draw('bones.png', '--skeleton'), clear = draw('clear.png', '--transparent');
  draw('dual.png', '--skinning', 'dual-quaternion');
  assert.deepEqual([plain.width, plain.height], [300, 200]);
  assert.ok(differing(plain, bones) > 100);
  assert.equal(clear.colour, 6);
  assert.equal(clear.pixels[3], 0, 'the corner is clear');
  assert.ok(clear.pixels.some((v, i) => i % 4 === 3 && v === 255), 'the body is not');
});

test('a failed command leaves the old output and no other file', () => {
  const folder = folderWithLine();
  writeFileSync(join(folder, 'out.glb'), 'old');
  writeFileSync(join(folder, 'out.png'), 'old');
  const runs = [
    ['pose', 'mannequin', '--line', 'nowhere.svg', '-o', 'out.glb', '--picture', 'out.png'],
    ['pose', 'mannequin', '--line', 'line.svg', '--body-line', 'tail', '-o', 'out.glb', '--picture', 'out.png'],
    ['convert', 'line.svg', 'out.glb'],
    ['render', 'line.svg', '-o', 'out.png'],
  ];
  for (const args of runs) {
    assert.equal(faultOf(croquis(args, { cwd: folder }), [2]), undefined);
    assert.deepEqual(readdirSync(folder).sort(), ['line.svg', 'out.glb', 'out.png']);
    assert.equal(readFileSync(join(folder, 'out.glb'), 'utf8'), 'old');
    assert.equal(readFileSync(join(folder, 'out.png'), 'utf8'), 'old');
  }
});

test('an input may be its own output', () => {
  const folder = folderWithLine();
  succeed(['character', 'cat', '-o', 'cat.glb'], { cwd: folder });
  succeed(['pose', 'cat.glb', '--line', 'line.svg', '-o', 'cat.glb'], { cwd: folder });
  assert.ok(gltfJson(join(folder, 'cat.glb')).nodes.length > 5);
});

test('of several strokes each poses the body line that its id names', () => {
  const folder = makeFolder();
  const svg = (...paths) => writeFileSync(join(folder, 'line.svg'), `<svg viewBox="0 0 1024 1024">${paths.join('')}</svg>`);
  const arm = '<path id="left_arm" d="M560 330 C 650 250 700 200 720 90"/>', trunk = `<path id="trunk" d="${curve}"/>`;
  svg(trunk, arm);
  const both = posed(folder, '-o', 'both.glb', '--picture', 'both.png');
  assert.deepEqual(both.lines.map((line) => line.body_line), ['trunk', 'left_arm']);
  assert.deepEqual(both.notices, []);
  // The strokes are longer than what they mean, and the arm's starts where the trunk's has no shoulder: a compromise.
  for (const line of both.lines) assert.ok(line.fit.mean_px < 40, `${line.body_line}: ${line.fit.mean_px}`);
  svg(trunk);
  posed(folder, '-o', 'trunk.glb');
  const [b, t] = ['both', 'trunk'].map((name) => gltfJson(join(folder, `${name}.glb`)).nodes);
  const rotation = (nodes, name) => JSON.stringify(nodes.find((node) => node.name === name).rotation);
  assert.notEqual(rotation(b, 'leftUpperArm'), rotation(t, 'leftUpperArm'));
});

test('several strokes without such ids find lines of their own', () => {
  const folder = makeFolder();
  succeed(['line', 'mannequin', '--body-line', 'left_arm', '-o', 'arm.svg'], { cwd: folder });
  succeed(['line', 'mannequin', '--body-line', 'right_leg', '-o', 'leg.svg'], { cwd: folder });
  const path = (name) => readFileSync(join(folder, name), 'utf8').match(/ d="([^"]+)"/)[1];
  writeFileSync(join(folder, 'line.svg'), `<svg viewBox="0 0 1024 1024"><path d="${path('arm.svg')}"/><path d="${path('leg.svg')}"/></svg>`);
  const report = posed(folder, '-o', 'out.glb');
  assert.deepEqual(report.lines.map((line) => line.body_line).sort(), ['left_arm', 'right_leg']);
});

test('of several strokes for one line the first is taken, and the report says so', () => {
  const folder = makeFolder();
  writeFileSync(join(folder, 'line.svg'), `<svg viewBox="0 0 1024 1024"><path d="${curve}"/><path d="M0 0L9 9"/></svg>`);
  assert.match(posed(folder, '--body-line', 'trunk', '-o', 'out.glb').notices.join(), /2 strokes, of which 1 is used/);
});

const rotationOf = (file, name) => gltfJson(file).nodes.find((node) => node.name === name).rotation ?? [0, 0, 0, 1];

test('the line of a pose, drawn again over it, changes nothing', () => {
  const folder = folderWithLine();
  posed(folder, '--body-line', 'left_foot-head', '-o', 'first.glb');
  for (const name of ['trunk', 'left_foot-head', 'right_arm']) {
    const read = JSON.parse(succeed(['line', 'first.glb', '--body-line', name, '-o', 'again.svg', '--json'], { cwd: folder }));
    assert.equal(read.body_line, name);
    const report = JSON.parse(succeed(['pose', 'first.glb', '--start', 'first.glb', '--line', 'again.svg', '--json', '-o', 'again.glb'], { cwd: folder }));
    assert.equal(report.body_line, name);
    const wanted = gltfJson(join(folder, 'first.glb')).nodes, got = gltfJson(join(folder, 'again.glb')).nodes;
    wanted.forEach((node, i) => {
      const a = node.rotation ?? [0, 0, 0, 1], b = got[i].rotation ?? [0, 0, 0, 1];
      const turn = 2 * Math.acos(Math.min(1, Math.abs(a.reduce((sum, v, k) => sum + v * b[k], 0)))) * 180 / Math.PI;
      assert.ok(turn <= 0.1, `${name}: ${node.name} turned by ${turn} degrees`);
    });
  }
});

test('line tells the shape of a pose and how strong it is', () => {
  const folder = makeFolder();
  const shape = (...args) => JSON.parse(succeed(['line', ...args, '--json', '-o', 'line.svg'], { cwd: folder }));
  const straight = shape('mannequin', '--body-line', 'trunk');
  assert.equal(straight.shape, 'straight');
  writeFileSync(join(folder, 'c.svg'), '<svg viewBox="0 0 1024 1024"><path d="M512 500 C 430 430 430 330 530 260"/></svg>');
  succeed(['pose', 'mannequin', '--line', 'c.svg', '--limits', 'cartoon', '-o', 'c.glb'], { cwd: folder });
  const bent = shape('c.glb', '--body-line', 'trunk');
  assert.equal(bent.shape, 'C');
  assert.ok(bent.strength > straight.strength + 0.05 && bent.turn_degrees > 40);
});

test('a pinned hand stays where it is, or goes where it is said', () => {
  const folder = folderWithLine('M512 500 C 440 430 440 330 540 230');
  const place = (file, name) => {
    const { joints } = JSON.parse(succeed(['info', file, '--json'], { cwd: folder }));
    return joints.find((j) => j.name === name).rest_position;
  };
  const far = (a, b) => Math.hypot(...a.map((v, i) => v - b[i]));
  posed(folder, '-o', 'free.glb');
  posed(folder, '--pin', 'leftHand', '-o', 'held.glb');
  const report = posed(folder, '--pin', 'leftHand', '--pin', 'rightHand=-0.5,1.2,0.2', '-o', 'both.glb');
  assert.equal(report.status, 'ok');
  const start = place('mannequin', 'leftHand');
  assert.ok(far(place('free.glb', 'leftHand'), start) > 0.02, 'a free hand is carried along');
  assert.ok(far(place('held.glb', 'leftHand'), start) < 2e-4);
  assert.ok(far(place('both.glb', 'leftHand'), start) < 2e-4);
  assert.ok(far(place('both.glb', 'rightHand'), [-0.5, 1.2, 0.2]) < 2e-4);
});

test('alternatives are listed, the likeliest first, and each can be taken', () => {
  const folder = folderWithLine();
  const report = posed(folder, '--body-line', 'auto', '--alternatives', '4', '-o', 'one.glb');
  assert.ok(report.alternatives.length >= 2 && report.alternatives.length <= 4);
  for (const other of report.alternatives) {
    assert.ok(other.label && other.body_line && ['forward', 'backward'].includes(other.direction) && Number.isFinite(other.cost));
  }
  const next = posed(folder, '--body-line', 'auto', '--alternative', '1', '-o', 'two.glb');
  assert.equal(next.body_line, report.alternatives[0].body_line);
  assert.equal(next.direction, report.alternatives[0].direction);
  assert.notDeepEqual(gltfJson(join(folder, 'one.glb')).nodes, gltfJson(join(folder, 'two.glb')).nodes);
});

test('exaggeration bends a line more, or not at all', () => {
  const folder = folderWithLine('M512 500 C 430 430 430 330 530 260');
  const turn = (factor) => {
    posed(folder, '--limits', 'none', '--no-floor', '--exaggerate', factor, '-o', 'out.glb');
    return JSON.parse(succeed(['line', 'out.glb', '--json', '-o', 'out.svg'], { cwd: folder })).turn_degrees;
  };
  const [flat, drawn, more] = ['0', '1', '1.5'].map(turn);
  assert.ok(flat < 0.5 * drawn && more > 1.1 * drawn, `${flat} ${drawn} ${more}`);
});

test('limits hold unless they are none, and a rotation matched may break them', () => {
  const folder = folderWithLine('M512 500 C 430 440 420 330 520 300');
  for (const limits of ['anatomical', 'dancer', 'cartoon']) {
    assert.deepEqual(posed(folder, '--limits', limits, '-o', 'out.glb').limit_violations, [], limits);
  }
  assert.equal(posed(folder, '--limits', 'none', '-o', 'out.glb').status, 'ok');
});

test('length policies and a locked root make different poses of one short line', () => {
  const folder = folderWithLine('M540 900 C 500 800 480 700 500 620');
  const head = (...args) => {
    posed(folder, '--body-line', 'left_foot-head', ...args, '-o', 'out.glb');
    return JSON.stringify(gltfJson(join(folder, 'out.glb')).nodes.map((node) => [node.rotation, node.translation]));
  };
  const poses = [head(), head('--length', 'scale'), head('--length', 'extend'), head('--root', 'lock')];
  assert.equal(new Set(poses).size, poses.length);
});

test('a sheet has a cell for each character and gesture', () => {
  const folder = makeFolder();
  succeed(['sheet', 'snake', 'tree', '--gestures', 'C,S,bow', '--cell', '64', '-o', 'sheet.png'], { cwd: folder });
  const sheet = readPng(join(folder, 'sheet.png'));
  assert.deepEqual([sheet.width, sheet.height], [3 * 64 + 4 * 4, 2 * 64 + 3 * 4]);
});

test('a start may be a pose of the shelf', () => {
  const folder = makeFolder();
  succeed(['pose', 'mannequin', '--start', 'relaxed', '-o', 'relaxed.glb'], { cwd: folder });
  assert.ok(Math.abs(rotationOf(join(folder, 'relaxed.glb'), 'leftUpperArm')[2]) > 0.4);
});
