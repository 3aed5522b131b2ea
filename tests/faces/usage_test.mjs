// What the program says about itself, and how it answers to arguments that are wrong.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { croquis, faultOf, makeFolder, succeed } from './support.mjs';

const commands = ['pose', 'line', 'sheet', 'info', 'render', 'convert', 'character', 'studio'];
const line = '<svg viewBox="0 0 1024 1024"><path d="M512 900 C 300 700 300 400 560 120"/></svg>';

test('--version says name and version', () => {
  assert.match(succeed(['--version']), /^croquis \d+\.\d+\.\d+\n$/);
});

test('--help names every command', () => {
  const help = succeed(['--help']);
  for (const command of commands) assert.match(help, new RegExp(`^  ${command} `, 'm'));
});

for (const command of commands) {
  test(`${command} --help gives the default of every option that is not required`, () => {
    // CLI11 breaks long lines: one entry is an option and the lines until the next.
    const entries = succeed([command, '--help']).split(/\n(?=  -)/).slice(1);
    assert.ok(entries.length >= 1);
    for (const entry of entries) {
      if (/^  -h/.test(entry)) continue;
      assert.match(entry.split('\n\n')[0], /\[required\]|\[default: [^\]]+\]|=\S+/, entry);
    }
  });

  if (command === 'studio') continue;  // it runs until it is stopped: studio_test.mjs
  test(`the example of ${command} --help runs`, () => {
    const folder = makeFolder();
    writeFileSync(join(folder, 'line.svg'), line);
    const example = succeed([command, '--help']).split('Example:')[1].trim().split(/\s+/);
    assert.deepEqual(example.slice(0, 2), ['croquis', command]);
    assert.equal(faultOf(croquis(example.slice(1), { cwd: folder }), [0]), undefined);
  });
}

test('the example of --help runs', () => {
  const example = succeed(['--help']).split('Example:')[1].trim().split('\n')[0].trim().split(/\s+/);
  assert.equal(faultOf(croquis(example.slice(1)), [0]), undefined);
});

const wrong = {
  'no command': [],
  'an unknown command': ['draw'],
  'an unknown option': ['pose', 'mannequin', '--lnie', 'x.svg', '-o', 'x.glb'],
  'no output': ['pose', 'mannequin'],
  'a line that is not there': ['pose', 'mannequin', '--line', 'nowhere.svg', '-o', 'x.glb'],
  'a rig that is not there': ['pose', 'nowhere.glb', '-o', 'x.glb'],
  'a folder as rig': ['pose', '.', '-o', 'x.glb'],
  'an output of no format': ['pose', 'mannequin', '-o', 'x.fbx'],
  'an output without extension': ['pose', 'mannequin', '-o', 'x'],
  'an output folder that is not there': ['pose', 'mannequin', '-o', 'nowhere/x.glb'],
  'a picture of another format': ['pose', 'mannequin', '-o', 'x.glb', '--picture', 'x.jpg'],
  'output and picture of one name': ['render', 'mannequin', '-o', 'x.glb'],
  'joints and a body line': ['pose', 'mannequin', '--line', 'line.svg', '--joints', 'hips,head', '--body-line', 'trunk', '-o', 'x.glb'],
  'a body line without a line': ['pose', 'mannequin', '--body-line', 'trunk', '-o', 'x.glb'],
  'a joint that is not there': ['pose', 'mannequin', '--line', 'line.svg', '--joints', 'hips,haed', '-o', 'x.glb'],
  'a body line that is not there': ['pose', 'mannequin', '--line', 'line.svg', '--body-line', 'tail', '-o', 'x.glb'],
  'a selection that forks': ['pose', 'mannequin', '--line', 'line.svg', '--joints', 'hips,spine,leftUpperLeg,rightUpperLeg,leftFoot,head,leftToes,rightFoot', '-o', 'x.glb'],
  'an unknown method': ['pose', 'mannequin', '--line', 'line.svg', '--method', 'magic', '-o', 'x.glb'],
  'an unknown plane': ['pose', 'mannequin', '--line', 'line.svg', '--plane', 'sky', '-o', 'x.glb'],
  'an unknown root mode': ['pose', 'mannequin', '--line', 'line.svg', '--root', 'fly', '-o', 'x.glb'],
  'an unknown direction': ['pose', 'mannequin', '--line', 'line.svg', '--direction', 'up', '-o', 'x.glb'],
  'limits that are none': ['pose', 'mannequin', '--limits', 'steel', '-o', 'x.glb'],
  'an unknown length policy': ['pose', 'mannequin', '--line', 'line.svg', '--length', 'long', '-o', 'x.glb'],
  'an unknown thing to move': ['pose', 'mannequin', '--line', 'line.svg', '--move', 'earth', '-o', 'x.glb'],
  'an exaggeration out of range': ['pose', 'mannequin', '--line', 'line.svg', '--exaggerate', '3', '-o', 'x.glb'],
  'an exaggeration that is no number': ['pose', 'mannequin', '--line', 'line.svg', '--exaggerate', 'much', '-o', 'x.glb'],
  'an exaggeration without a line': ['pose', 'mannequin', '--exaggerate', '1.5', '-o', 'x.glb'],
  'a pin of no joint': ['pose', 'mannequin', '--line', 'line.svg', '--pin', 'wing', '-o', 'x.glb'],
  'a pin without a place': ['pose', 'mannequin', '--line', 'line.svg', '--pin', 'leftHand=1,2', '-o', 'x.glb'],
  'a pin at no number': ['pose', 'mannequin', '--line', 'line.svg', '--pin', 'leftHand=1,nan,3', '-o', 'x.glb'],
  'too many alternatives': ['pose', 'mannequin', '--line', 'line.svg', '--alternatives', '99', '-o', 'x.glb'],
  'an alternative that there is not': ['pose', 'mannequin', '--line', 'line.svg', '--alternative', '19', '-o', 'x.glb'],
  'the method line with a direction by length': ['pose', 'mannequin', '--line', 'line.svg', '--direction', 'length', '-o', 'x.glb'],
  'a line read into no SVG': ['line', 'mannequin', '-o', 'x.png'],
  'a line read off no body line': ['line', 'mannequin', '--body-line', 'tail', '-o', 'x.svg'],
  'a line read off joints that fork': ['line', 'mannequin', '--joints', 'hips,head,leftHand', '-o', 'x.svg'],
  'a line of no frame': ['line', 'mannequin', '--frame', '3', '-o', 'x.svg'],
  'a line read without an output': ['line', 'mannequin'],
  'a sheet of a gesture that there is not': ['sheet', 'snake', '--gestures', 'C,sneeze', '-o', 'x.png'],
  'a sheet of tiny cells': ['sheet', 'snake', '--cell', '3', '-o', 'x.png'],
  'a sheet of no rig': ['sheet', 'nowhere.glb', '-o', 'x.png'],
  'a sheet in no picture': ['sheet', 'snake', '-o', 'x.glb'],
  'an unknown view': ['pose', 'mannequin', '--line', 'line.svg', '--view', 'below', '-o', 'x.glb'],
  'the ground plane from above': ['pose', 'mannequin', '--line', 'line.svg', '--method', 'rotation', '--view', 'top', '--plane', 'ground', '-o', 'x.glb'],
  'a view and a camera': ['pose', 'mannequin', '--view', 'top', '--camera', 'camera.json', '-o', 'x.glb'],
  'a camera that is not there': ['pose', 'mannequin', '--camera', 'nowhere.json', '-o', 'x.glb'],
  'a camera that is none': ['pose', 'mannequin', '--camera', 'line.svg', '-o', 'x.glb'],
  'a line that is none': ['pose', 'mannequin', '--line', 'camera.json', '-o', 'x.glb'],
  'a line that is a dot': ['pose', 'mannequin', '--line', 'dot.svg', '-o', 'x.glb'],
  'an unknown form': ['pose', 'mannequin', '--as', 'statue', '-o', 'x.glb'],
  'unknown skinning': ['render', 'mannequin', '--skinning', 'cubic', '-o', 'x.png'],
  'a size that is none': ['render', 'mannequin', '--size', '100', '-o', 'x.png'],
  'a size too large': ['render', 'mannequin', '--size', '99999x2', '-o', 'x.png'],
  'a frame of no clip': ['render', 'mannequin', '--frame', '0', '-o', 'x.png'],
  'a frame that is no number': ['render', 'mannequin', '--frame', 'two', '-o', 'x.png'],
  'a start of another skeleton': ['pose', 'mannequin', '--start', 'cat', '-o', 'x.glb'],
  'a start that is not there': ['pose', 'mannequin', '--start', 'nowhere.bvh:3', '-o', 'x.glb'],
  'a frame of a start without clips': ['pose', 'mannequin', '--start', 'mannequin:1', '-o', 'x.glb'],
  'an unknown character': ['character', 'dragon', '-o', 'x.glb'],
  'a proportion out of range': ['character', 'mannequin', '--heads', '30', '-o', 'x.glb'],
  'heads of a cat': ['character', 'cat', '--heads', '5', '-o', 'x.glb'],
  'an output of no name': ['pose', 'mannequin', '-o', ''],
  'a line far off the view': ['pose', 'mannequin', '--line', 'far.svg', '-o', 'x.glb'],
  'a proportion that is no number': ['character', 'mannequin', '--heads', 'six', '-o', 'x.glb'],
  'proportions of a file': ['render', 'nowhere.glb', '--heads', '6', '-o', 'x.png'],
  'stretched bones in a BVH': ['pose', 'mannequin', '--line', 'line.svg', '--method', 'curvilinear', '-o', 'x.bvh'],
};
for (const [what, args] of Object.entries(wrong)) {
  test(`${what} ends in status 2 and one line`, () => {
    const folder = makeFolder();
    writeFileSync(join(folder, 'line.svg'), line);
    writeFileSync(join(folder, 'far.svg'), '<svg viewBox="0 0 1024 1024"><path d="M5000 5000 L6000 6000"/></svg>');
    writeFileSync(join(folder, 'dot.svg'), '<svg><path d="M5 5L5 5"/></svg>');
    writeFileSync(join(folder, 'camera.json'), '{"projection":"orthographic","height":2,"position":[0,1,5],"target":[0,1,0],"up":[0,1,0],"width":512,"height_px":512}');
    assert.equal(faultOf(croquis(args, { cwd: folder }), [2]), undefined);
  });
}

test('a usage error says where help is, a misspelt word which was meant', () => {
  assert.match(croquis(['pose', 'mannequin']).stderr, /croquis pose --help/);
  const folder = makeFolder();
  writeFileSync(join(folder, 'line.svg'), line);
  const run = croquis(['pose', 'mannequin', '--line', 'line.svg', '--joints', 'hips,haed', '-o', 'x.glb'], { cwd: folder });
  assert.match(run.stderr, /'haed'.*'head'/);
  assert.match(croquis(['character', 'mannequin', '--heads', 'six', '-o', 'x.glb']).stderr, /--heads 'six': wanted a number/);
});

test('a stroke outside the view is told by the name of its file', () => {
  const folder = makeFolder();
  writeFileSync(join(folder, 'far.svg'), '<svg viewBox="0 0 1024 1024"><path d="M5000 5000 L6000 6000"/></svg>');
  assert.match(croquis(['pose', 'mannequin', '--line', 'far.svg', '-o', 'x.glb'], { cwd: folder }).stderr, /^croquis: far\.svg: /);
});
