// Holds glTF files against the Khronos validator: prints each error, and exits with 1 if there is one that the file's
// source did not have.
// usage: node validate_gltf.mjs [FILE | @LIST]...   a LIST has one FILE per line, or FILE<tab>SOURCE: as many errors of
// a kind as the source has are forgiven. Exits with 77 where the npm package gltf-validator is not installed.
//        node validate_gltf.mjs --written-by TEST_PROGRAM   all that the tests write with CROQUIS_WRITE_TO set
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';

const roots = [import.meta.url, resolve(process.cwd(), 'x.js'), ...(process.env.CROQUIS_NPM ? [resolve(process.env.CROQUIS_NPM, 'x.js')] : [])];
const validator = roots.reduce((found, root) => {
  if (found) return found;
  try {
    return createRequire(root)('gltf-validator');
  } catch {
    return null;
  }
}, null);
if (!validator) {
  console.error('the npm package gltf-validator is not installed: tools/setup.sh npm');
  process.exit(77);
}

async function errors_of(file) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), {
    uri: file,
    maxIssues: 0,
    ignoredIssues: [],
    externalResourceFunction: async (uri) => {
      const path = resolve(dirname(file), decodeURIComponent(uri));
      if (!existsSync(path)) throw new Error(`${uri} is not there`);
      return new Uint8Array(readFileSync(path));
    },
  });
  return report.issues.messages.filter((message) => message.severity === 0);
}

const count_by_code = (errors) => {
  const counts = new Map();
  for (const { code } of errors) counts.set(code, (counts.get(code) ?? 0) + 1);
  return counts;
};

let written = null;
const given = process.argv.slice(2);
if (given[0] === '--written-by') {
  written = mkdtempSync(join(tmpdir(), 'croquis_written_'));
  execFileSync(given[1], ['--gtest_brief=1', '--gtest_filter=*Write*:*ProjectFile*'], {
    env: { ...process.env, CROQUIS_WRITE_TO: written },
    stdio: ['ignore', 'ignore', 'inherit'],
  });
  const list = join(written, 'list.txt');
  if (!existsSync(list)) {
    console.error('the tests wrote no file: is the shared data there?');
    process.exit(77);
  }
  given.splice(0, 2, '@' + list);
}

const files = given.flatMap((argument) =>
  argument.startsWith('@')
    ? readFileSync(argument.slice(1), 'utf8').split('\n').filter(Boolean).map((line) => line.split('\t'))
    : [[argument, '']]);
let faults = 0;
for (const [file, source] of files) {
  const errors = await errors_of(file).catch((error) => [{ code: 'UNREADABLE', message: String(error), pointer: '' }]);
  const forgiven = source ? count_by_code(await errors_of(source).catch(() => [])) : new Map();
  for (const { code, message, pointer } of errors) {
    const left = forgiven.get(code) ?? 0;
    if (left > 0) {
      forgiven.set(code, left - 1);
      continue;
    }
    faults += 1;
    if (faults <= 50) console.error(`${file}: ${pointer}: ${code}: ${message}`);
  }
}
if (written) rmSync(written, { recursive: true });
console.log(`${files.length} files held against the glTF validator, ${faults} errors`);
process.exit(faults > 0 || files.length === 0 ? 1 : 0);
