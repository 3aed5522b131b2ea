// SPDX-License-Identifier: MIT
// Poses real files at random with Croquis and with three.js (shapes, then skin) and compares every vertex: positions to
// 1e-5 of the character's height. Exits with 77 where the npm package three or the files are not there.
// usage: node three_check.mjs POSE_DUMP_PROGRAM DATA_FOLDER
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [program, data] = process.argv.slice(2);
const files = [
  'gltf/simple_skin.gltf', 'gltf/rigged_figure.glb', 'gltf/cesium_man.gltf', 'gltf/fox_khronos.glb',
  'gltf/m2m_snake.glb', 'gltf/kaykit_knight.glb', 'gltf/quaternius_man_casual.glb', 'gltf/robot_expressive.glb',
  'gltf/momentum_8_influences.glb', 'gltf/morph_stress_test.gltf', 'gltf/tinygltf_sparse_morph.glb',
  'vrm/addon_pose_rotation_scale_shape_key_skinned.vrm', 'vrm/cryptovoxels_vrm0.vrm',
];
const tolerance = 1e-5; // of the height

const skip = (why) => {
  console.error(why);
  process.exit(77);
};
function three_folder() {
  const roots = [import.meta.url, resolve(process.cwd(), 'x.js')];
  if (process.env.CROQUIS_NPM) roots.push(resolve(process.env.CROQUIS_NPM, 'x.js'));
  for (const root of roots) {
    try {
      return dirname(dirname(createRequire(root).resolve('three')));
    } catch {
      // the next one
    }
  }
  return skip('the npm package three is not installed: tools/setup.sh npm');
}
const folder = three_folder();
const present = files.filter((file) => existsSync(join(data, file)));
if (present.length === 0) skip(`no file in ${data}`);

// What three.js expects of a browser.
globalThis.self ??= globalThis;
globalThis.ProgressEvent ??= class extends Event {};
const load = (file) => import(pathToFileURL(join(folder, file)).href);
const { Matrix4, Texture, Vector3, Vector4 } = await load('build/three.module.js');
const { GLTFLoader } = await load('examples/jsm/loaders/GLTFLoader.js');

async function read(path) {
  const loader = new GLTFLoader();
  loader.register(() => ({ name: 'no pictures', loadTexture: async () => new Texture() }));
  const bytes = readFileSync(path);
  return loader.parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength), '');
}

// node -> object of three.js, and "node/primitive" -> its mesh, in the order of the scene as the parts are.
function index(gltf) {
  const nodes = new Map(), meshes = new Map();
  gltf.scene.traverse((object) => {
    const node = gltf.parser.associations.get(object)?.nodes;
    if (node === undefined) return;
    nodes.set(node, object);
    const primitives = object.isMesh ? [object] : object.children.filter((c) => c.isMesh && nodeless(gltf, c));
    primitives.forEach((mesh, p) => meshes.set(`${node}/${p}`, mesh));
  });
  return { nodes, meshes };
}
const nodeless = (gltf, object) => gltf.parser.associations.get(object)?.nodes === undefined;

// three.js skins by four influences; with more it is done here, by its own bones and after its own shapes.
function skinned_by_all(mesh, v, sets, target) {
  Object.getPrototypeOf(mesh.constructor.prototype).getVertexPosition.call(mesh, v, target);
  const sum = new Vector3(), matrix = new Matrix4();
  for (let set = 0; set < sets; ++set) {
    const [indices, weights] = set === 0 ? ['skinIndex', 'skinWeight'] : [`joints_${set}`, `weights_${set}`];
    const i = new Vector4().fromBufferAttribute(mesh.geometry.attributes[indices], v);
    const w = new Vector4().fromBufferAttribute(mesh.geometry.attributes[weights], v);
    for (const c of ['x', 'y', 'z', 'w']) {
      if (w[c] === 0) continue;
      matrix.multiplyMatrices(mesh.skeleton.bones[i[c]].matrixWorld, mesh.skeleton.boneInverses[i[c]]);
      sum.addScaledVector(target.clone().applyMatrix4(matrix), w[c]);
    }
  }
  return target.copy(sum);
}

function world_position(mesh, v, influences) {
  const target = new Vector3();
  if (influences > 4) return skinned_by_all(mesh, v, Math.ceil(influences / 4), target);
  return mesh.getVertexPosition(v, target).applyMatrix4(mesh.matrixWorld);
}

// Which elements are the part's vertices: all, or those that the triangles use.
function elements(mesh, count) {
  const all = mesh.geometry.attributes.position.count;
  if (all === count) return [...Array(all).keys()];
  return [...new Set(mesh.geometry.index.array)].sort((a, b) => a - b);
}

async function compare(path, seed) {
  const dump = JSON.parse(execFileSync(program, [path, String(seed)], { maxBuffer: 1 << 30 }).toString());
  const gltf = await read(path);
  const { nodes, meshes } = index(gltf);
  for (const [node, { translation, rotation, scale }] of Object.entries(dump.nodes)) {
    const object = nodes.get(Number(node));
    if (!object) continue;
    object.position.set(...translation);
    object.quaternion.set(...rotation);
    object.scale.set(...scale);
  }
  const ordered = [...meshes.values()];
  if (ordered.length !== dump.parts.length) throw new Error(`${ordered.length} meshes, ${dump.parts.length} parts`);
  dump.parts.forEach((part, i) => {
    if (part.weights.length > 0) ordered[i].morphTargetInfluences = part.weights;
  });
  gltf.scene.updateMatrixWorld(true);

  let worst = 0, low = Infinity, high = -Infinity, vertices = 0;
  dump.parts.forEach((part, i) => {
    const list = elements(ordered[i], part.positions.length);
    if (list.length !== part.positions.length) throw new Error(`part ${i}: ${list.length} vertices, not ${part.positions.length}`);
    list.forEach((v, k) => {
      const theirs = world_position(ordered[i], v, part.influences);
      const distance = theirs.distanceTo(new Vector3(...part.positions[k]));
      if (!(distance <= worst)) worst = distance;
      low = Math.min(low, theirs.y);
      high = Math.max(high, theirs.y);
      vertices += 1;
    });
  });
  return { relative: worst / (high - low), vertices };
}

let failed = 0;
for (const file of present) {
  for (const seed of [1, 2]) {
    try {
      const { relative, vertices } = await compare(join(data, file), seed);
      const good = relative <= tolerance && vertices > 0;
      if (!good) failed += 1;
      console.log(`${good ? 'same' : 'DIFFERENT'} ${file} seed ${seed}: ${vertices} vertices, ${relative.toExponential(1)} of the height`);
    } catch (error) {
      failed += 1;
      console.log(`FAILED ${file} seed ${seed}: ${error.message}`);
    }
  }
}
process.exit(failed > 0 ? 1 : 0);
