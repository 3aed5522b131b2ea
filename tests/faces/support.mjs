// What the tests of the program share: running it under limits, a folder of their own, shared data, and readers of its
// outputs that know nothing of the engine.
import { spawnSync } from 'node:child_process';
import { createRequire } from 'node:module';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { inflateSync } from 'node:zlib';

export const repository = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
export const program = process.env.CROQUIS_PROGRAM ?? join(repository, 'build/release/croquis');
export const sanitized = process.env.CROQUIS_SANITIZED === '1';

const shared = process.env.CROQUIS_DATA ?? join(repository, '../shared/data');
/** The path of a shared file or folder, or undefined where it is not there. */
export function dataPath(name) {
  const path = join(shared, name);
  return existsSync(path) ? path : undefined;
}

/** A fresh folder that goes when the tests end. */
export function makeFolder() {
  const folder = mkdtempSync(join(tmpdir(), 'croquis-test-'));
  process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** Runs the program: in bounded time and 4 GB of address space (which AddressSanitizer's own shadow exceeds). */
export function croquis(args, { cwd = makeFolder(), seconds = 120 } = {}) {
  const limit = sanitized ? '' : 'ulimit -v 4194304; ';
  const run = spawnSync('bash', ['-c', `${limit}exec "$0" "$@"`, program, ...args],
    { cwd, encoding: 'utf8', timeout: seconds * 1000, maxBuffer: 1 << 28 });
  return { status: run.status, signal: run.signal, stdout: run.stdout, stderr: run.stderr };
}

/** What is wrong with a run that should have ended in 0, or in 2 with one line on stderr; undefined if nothing is. */
export function faultOf(run, allowed = [0, 2]) {
  if (run.signal) return `killed by ${run.signal}: ${run.stderr.slice(-400)}`;
  if (!allowed.includes(run.status)) return `exit status ${run.status}: ${run.stderr.slice(0, 600)}`;
  if (run.status === 0) return run.stderr === '' ? undefined : `stderr after success: ${run.stderr}`;
  if (!/^croquis: [^\n]+\n$/.test(run.stderr)) return `stderr is not one line: ${JSON.stringify(run.stderr)}`;
  if (run.stdout !== '') return `stdout after a failure: ${run.stdout.slice(0, 200)}`;
  return undefined;
}

/** Runs the program, which must succeed, and gives its stdout. */
export function succeed(args, options) {
  const run = croquis(args, options);
  if (run.status !== 0) throw new Error(`croquis ${args.join(' ')}\n  ended with ${run.status ?? run.signal}: ${run.stderr}`);
  return run.stdout;
}

/** The Khronos validator's errors of a glTF file, as "CODE pointer", sorted. */
export async function validatorErrors(file) {
  const validator = createRequire(join(repository, 'package.json'))('gltf-validator');
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), {
    uri: file, maxIssues: 10000,
    externalResourceFunction: async (uri) => new Uint8Array(readFileSync(join(dirname(file), decodeURIComponent(uri)))),
  });
  return report.issues.messages.filter((m) => m.severity === 0).map((m) => `${m.code} ${m.pointer ?? ''}`).sort();
}
export const hasValidator = existsSync(join(repository, 'node_modules/gltf-validator'));

/** The JSON of a .glb, .vrm, .croquis or .gltf file. */
export function gltfJson(file) {
  const bytes = readFileSync(file);
  if (bytes.toString('latin1', 0, 4) !== 'glTF') return JSON.parse(bytes.toString('utf8'));
  return JSON.parse(bytes.toString('utf8', 20, 20 + bytes.readUInt32LE(12)));
}

const multiply = (a, b) => Array.from({ length: 16 }, (_, i) =>
  [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + (i % 4)] * b[4 * Math.floor(i / 4) + k], 0));
function localMatrix({ matrix, translation: t = [0, 0, 0], rotation: [x, y, z, w] = [0, 0, 0, 1], scale: s = [1, 1, 1] }) {
  if (matrix) return matrix;
  const n = Math.hypot(x, y, z, w);
  [x, y, z, w] = [x / n, y / n, z / n, w / n];
  return [
    s[0] * (1 - 2 * (y * y + z * z)), s[0] * 2 * (x * y + z * w), s[0] * 2 * (x * z - y * w), 0,
    s[1] * 2 * (x * y - z * w), s[1] * (1 - 2 * (x * x + z * z)), s[1] * 2 * (y * z + x * w), 0,
    s[2] * 2 * (x * z + y * w), s[2] * 2 * (y * z - x * w), s[2] * (1 - 2 * (x * x + y * y)), 0, ...t, 1];
}

/** The distance of every node of a glTF document to its parent in the world: { nodeIndex: length }. */
export function boneLengths(json) {
  const lengths = {};
  const visit = (index, world, position) => {
    const own = multiply(world, localMatrix(json.nodes[index]));
    const here = own.slice(12, 15);
    if (position) lengths[index] = Math.hypot(...here.map((v, i) => v - position[i]));
    for (const child of json.nodes[index].children ?? []) visit(child, own, here);
  };
  const children = new Set(json.nodes.flatMap((node) => node.children ?? []));
  json.nodes.forEach((_, i) => { if (!children.has(i)) visit(i, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]); });
  return lengths;
}

/** Size, bit depth, colour type and pixels (RGBA or RGB rows) of a PNG without interlacing. */
export function readPng(file) {
  const bytes = readFileSync(file);
  if (bytes.toString('latin1', 1, 4) !== 'PNG') throw new Error(`${file} is no PNG`);
  const header = {}, data = [];
  for (let at = 8; at < bytes.length;) {
    const length = bytes.readUInt32BE(at), type = bytes.toString('latin1', at + 4, at + 8);
    const body = bytes.subarray(at + 8, at + 8 + length);
    if (type === 'IHDR') Object.assign(header, { width: body.readUInt32BE(0), height: body.readUInt32BE(4), depth: body[8], colour: body[9] });
    if (type === 'IDAT') data.push(body);
    at += 12 + length;
  }
  const channels = { 2: 3, 6: 4 }[header.colour], stride = header.width * channels, raw = inflateSync(Buffer.concat(data));
  const pixels = Buffer.alloc(stride * header.height);
  for (let y = 0; y < header.height; ++y) {
    const filter = raw[y * (stride + 1)];
    for (let i = 0; i < stride; ++i) {
      const left = i >= channels ? pixels[y * stride + i - channels] : 0, up = y ? pixels[(y - 1) * stride + i] : 0;
      const corner = y && i >= channels ? pixels[(y - 1) * stride + i - channels] : 0;
      const p = left + up - corner;
      const nearest = Math.abs(p - left) <= Math.abs(p - up) && Math.abs(p - left) <= Math.abs(p - corner) ? left
        : Math.abs(p - up) <= Math.abs(p - corner) ? up : corner;
      pixels[y * stride + i] = raw[y * (stride + 1) + 1 + i] + [0, left, up, (left + up) >> 1, nearest][filter];
    }
  }
  return { ...header, channels, pixels };
}
