// A drawn C and a drawn S on rigs that people use: the pose follows the line, bones keep their lengths, the file is as
// valid as it was, and the picture shows both.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { basename, extname, join } from 'node:path';
import test from 'node:test';
import { boneLengths, dataPath, gltfJson, hasValidator, makeFolder, readPng, succeed, validatorErrors } from './support.mjs';

const rigs = ['gltf/cesium_man.gltf', 'gltf/rigged_figure.glb', 'gltf/fox_khronos.glb', 'gltf/m2m_snake.glb', 'gltf/kaykit_knight.glb',
  'gltf/quaternius_man_casual.glb', 'vrm/cryptovoxels_vrm0.vrm', 'vrm/debug_robot_vrm1.vrm', 'bvh/cmu_01_01.bvh', 'bvh/bandai1_walk_normal_001.bvh'];
const kSide = 1024;

const sub = (a, b) => a.map((v, i) => v - b[i]);
const dot = (a, b) => a.reduce((sum, v, i) => sum + v * b[i], 0);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const unit = (a) => a.map((v) => v / Math.hypot(...a));

/** A camera that looks squarely at a line of joints, and the picture position of a point in it. */
function cameraOn(points, front, length) {
  const whole = sub(points.at(-1), points[0]);
  const along = Math.abs(dot(whole, front)) / Math.hypot(...whole);
  const back = along < 0.7 ? front : cross([0, 1, 0], front);  // from the front, or from the side if it points there
  const target = points.reduce((sum, p) => sum.map((v, i) => v + p[i] / points.length), [0, 0, 0]);
  const upright = Math.abs(back[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0];
  const right = unit(cross(upright, back)), up = cross(back, right), height = 3 * length, scale = kSide / height;
  const camera = { projection: 'orthographic', height, position: target.map((v, i) => v + back[i] * 2 * height), target, up: upright, width: kSide, height_px: kSide };
  const project = (p) => [kSide / 2 + scale * dot(sub(p, target), right), kSide / 2 - scale * dot(sub(p, target), up)];
  return { camera, project, scale };
}

/** Points of a curve of a given length that starts at `from` along `heading` and turns as `turn(t)`, t from 0 to 1. */
function curve(from, heading, length, turn) {
  const points = [from], steps = 200;
  for (let i = 0; i < steps; ++i) {
    const angle = heading + turn((i + 0.5) / steps), [x, y] = points.at(-1);
    points.push([x + (length / steps) * Math.cos(angle), y + (length / steps) * Math.sin(angle)]);
  }
  return points;
}
const shapes = { C: (t) => 1.6 * (t - 0.5), S: (t) => 0.7 * Math.cos(2 * Math.PI * t) };

for (const rig of rigs) {
  const file = dataPath(rig);
  for (const [letter, turn] of Object.entries(shapes)) {
    test(`${rig} takes a drawn ${letter}`, { skip: file ? false : 'no shared data' }, async () => {
      const folder = makeFolder(), { joints, body_lines, front } = JSON.parse(succeed(['info', file, '--json']));
      const jointOf = (reference) => reference.startsWith('#') ? joints[+reference.slice(1)] : joints.find((j) => j.name === reference);
      const line = body_lines[0].joints.map(jointOf), points = line.map((j) => j.rest_position);
      const length = points.slice(1).reduce((sum, p, i) => sum + Math.hypot(...sub(p, points[i])), 0);
      const { camera, project, scale } = cameraOn(points, front, length);
      const [first, last] = [project(points[0]), project(points.at(-1))];
      const stroke = curve(first, Math.atan2(last[1] - first[1], last[0] - first[0]), length * scale, turn);
      writeFileSync(join(folder, 'camera.json'), JSON.stringify(camera));
      writeFileSync(join(folder, 'line.svg'), `<svg viewBox="0 0 ${kSide} ${kSide}"><polyline points="${stroke.map((p) => p.join(',')).join(' ')}"/></svg>`);

      const format = extname(file) === '.gltf' ? '.glb' : extname(file);
      const args = ['pose', file, '--line', 'line.svg', '--camera', 'camera.json', '--joints', line.map((j) => `#${j.index}`).join(), '--json'];
      const report = JSON.parse(succeed([...args, '-o', `out${format}`, '--picture', 'out.png'], { cwd: folder }));
      assert.equal(report.status, 'ok');
      assert.equal(report.direction, 'forward');
      assert.ok(report.bone_length_drift < 1e-6);
      assert.ok(report.fit.mean_px < 0.08 * length * scale, `${report.fit.mean_px} px off a line of ${length * scale}`);
      assert.ok(report.fit.tangent_deg < 25, `${report.fit.tangent_deg} degrees off its direction`);

      if (format === '.bvh') {
        const hierarchy = (path) => readFileSync(path, 'latin1').split('MOTION')[0];
        assert.equal(hierarchy(join(folder, 'out.bvh')), hierarchy(file));
        assert.match(readFileSync(join(folder, 'out.bvh'), 'latin1'), /Frames:\s*1\s/);
        succeed([...args, '-o', 'out.glb'], { cwd: folder });
        if (hasValidator) assert.deepEqual(await validatorErrors(join(folder, 'out.glb')), []);
      } else {
        const a = boneLengths(gltfJson(file)), b = boneLengths(gltfJson(join(folder, `out${format}`)));
        for (const i of Object.keys(a)) assert.ok(Math.abs(a[i] - b[i]) <= 1e-6 * Math.max(a[i], 1e-3 * length), `node ${i}: ${a[i]} became ${b[i]}`);
        if (hasValidator) {
          const had = await validatorErrors(file);
          const fresh = (await validatorErrors(join(folder, `out${format}`))).filter((error) => !had.includes(error));
          assert.deepEqual(fresh, [], basename(file));
        }
      }
      const picture = readPng(join(folder, 'out.png'));
      assert.deepEqual([picture.width, picture.height, picture.depth], [kSide, kSide, 8]);
      const at = ([x, y]) => [...picture.pixels.subarray((Math.round(y) * kSide + Math.round(x)) * picture.channels, (Math.round(y) * kSide + Math.round(x)) * picture.channels + 3)];
      for (const place of [40, 100, 160]) {
        const ink = at(stroke[place]), paper = at([10, 10]);
        assert.ok(Math.hypot(...sub(ink, paper)) > 60, `ink ${ink} on paper ${paper} at ${stroke[place]}`);
      }
      assert.ok(new Set(Array.from({ length: 4096 }, (_, i) => at([(i % 64) * 16, Math.floor(i / 64) * 16]).join())).size > 50, 'more than paper and ink');
    });
  }
}
