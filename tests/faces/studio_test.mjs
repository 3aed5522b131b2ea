// The program as a server of the studio's page: on loopback alone, and of that folder alone.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import { join } from 'node:path';
import test, { after } from 'node:test';
import { croquis, faultOf, makeFolder, program } from './support.mjs';

const folder = makeFolder();
const page = join(folder, 'page');
mkdirSync(join(page, 'assets'), { recursive: true });
writeFileSync(join(page, 'index.html'), '<!doctype html><title>Croquis</title>');
writeFileSync(join(page, 'assets/engine.wasm'), Buffer.from([0, 97, 115, 109]));
writeFileSync(join(page, 'table.webmanifest'), '{}');
writeFileSync(join(folder, 'secret.txt'), 'not for everyone');

const started = [];
after(() => started.forEach((server) => server.kill()));

/** Starts the program and gives the address it prints. */
function serve(args) {
  const server = spawn(program, ['studio', '--page', page, ...args]);
  started.push(server);
  return new Promise((resolve, reject) => {
    let text = '';
    server.stdout.on('data', (chunk) => {
      text += chunk;
      const address = text.match(/http:\/\/127\.0\.0\.1:\d+\//);
      if (address) resolve(address[0]);
    });
    server.on('exit', (status) => reject(new Error(`ended with ${status}`)));
  });
}

/** What the server answers to a path as it is written; fetch() would tidy it first. */
function rawGet(address, path) {
  return new Promise((resolve, reject) => {
    let answer = '';
    const socket = connect(Number(new URL(address).port), '127.0.0.1', () => socket.write(`GET ${path} HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n`));
    socket.setEncoding('latin1').on('data', (chunk) => (answer += chunk)).on('end', () => resolve(answer)).on('error', reject);
  });
}

test('it prints its address and serves the page with the types that a browser wants', async () => {
  const address = await serve(['--port', '0']);
  const types = { '': /^text\/html/, 'index.html': /^text\/html/, 'assets/engine.wasm': /^application\/wasm$/, 'table.webmanifest': /^application\/manifest\+json$/ };
  for (const [path, type] of Object.entries(types)) {
    const answer = await fetch(address + path);
    assert.equal(answer.status, 200, path);
    assert.match(answer.headers.get('content-type'), type, path);
  }
  assert.deepEqual([...new Uint8Array(await (await fetch(`${address}assets/engine.wasm`)).arrayBuffer())], [0, 97, 115, 109]);
  assert.equal((await fetch(`${address}nowhere.js`)).status, 404);
});

test('nothing outside the folder is given out', async () => {
  const address = await serve(['--port', '0']);
  for (const path of ['/../secret.txt', '/assets/../../secret.txt', '/%2e%2e/secret.txt', '/..%2fsecret.txt', '/%2e%2e%2fsecret.txt', '/..\\secret.txt', `/${folder}/secret.txt`, '/assets']) {
    const answer = await rawGet(address, path);
    assert.match(answer, /^HTTP\/1\.1 (4\d\d|30\d) /, path);
    assert.doesNotMatch(answer, /not for everyone/, path);
  }
});

test('a port that is taken, a folder without the page and a page that was never built are told in one line', async () => {
  const port = new URL(await serve(['--port', '0'])).port;
  const wrong = { [`port ${port} cannot be opened`]: ['--page', page, '--port', port], 'no built studio in': ['--page', folder], '65536': ['--port', '65536'] };
  for (const [words, args] of Object.entries(wrong)) {
    const run = croquis(['studio', ...args]);
    assert.equal(faultOf(run, [2]), undefined);
    assert.ok(run.stderr.includes(words), run.stderr);
  }
  const alone = join(folder, 'croquis');
  copyFileSync(program, alone);
  const run = spawnSync(alone, ['studio'], { encoding: 'utf8', timeout: 60_000 });
  assert.equal(run.status, 2);
  assert.match(run.stderr, /^croquis: the studio is not built: run 'make studio' once[^\n]*\n$/);
});
