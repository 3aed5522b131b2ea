// SPDX-License-Identifier: MIT
// What every story starts from: the built page, served on loopback, open in Debian's Chromium; a pen, fingers, keys.
import assert from 'node:assert/strict';
import { createReadStream, existsSync, readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, resolve } from 'node:path';
import { chromium } from 'playwright-core';

export const ROOT = resolve(import.meta.dirname ?? new URL('.', import.meta.url).pathname, '../../..');
const PAGE = process.env.CROQUIS_PAGE ?? join(ROOT, 'build/studio');
export const DATA = [process.env.CROQUIS_DATA, join(ROOT, '../shared/data')].find((path) => path && existsSync(path));
const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm', '.svg': 'image/svg+xml', '.png': 'image/png', '.webmanifest': 'application/manifest+json' };

export function servePage() {
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url, 'http://x').pathname);
    const file = join(PAGE, path.endsWith('/') ? `${path}index.html` : path);
    if (!file.startsWith(PAGE) || !existsSync(file) || !statSync(file).isFile()) return response.writeHead(404).end();
    response.writeHead(200, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream' });
    createReadStream(file).pipe(response);
  });
  return new Promise((done) => server.listen(0, '127.0.0.1', () => done(server)));
}

export const launch = () =>
  chromium.launch({
    timeout: 120_000,
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'],
  });

/** For a machine that is busy with other things and draws in software; nothing in the stories depends on time. */
const PATIENCE = 240_000;

/** A fresh browser profile with the studio open. Every fault the page reports ends up in `faults`. */
export class Visit {
  static async open(browser, url, options = {}) {
    const context = await browser.newContext({ viewport: { width: 960, height: 640 }, acceptDownloads: true, ...options });
    const visit = new Visit(context, url);
    await visit.load();
    return visit;
  }

  constructor(context, url) {
    this.context = context;
    this.url = url;
    this.faults = [];
  }

  /** In draft quality, unless a story is about the picture: software rendering is slow. */
  async load(query = '?quality=draft') {
    this.page = await this.context.newPage();
    this.page.setDefaultTimeout(PATIENCE);
    this.page.setDefaultNavigationTimeout(PATIENCE);
    this.page.on('console', (message) => message.type() === 'error' && this.faults.push(message.text()));
    this.page.on('pageerror', (error) => this.faults.push(String(error)));
    await this.page.goto(this.url + query);
    await this.ready();
  }

  async ready() {
    await this.page.waitForFunction(() => document.documentElement.dataset.ready === 'true');
    this.wire = await this.context.newCDPSession(this.page);
  }

  /** The engine's project as the page mirrors it. */
  state() {
    return this.page.evaluate(() => globalThis.croquis.table.state.value);
  }

  joints(actor) {
    return this.page.evaluate((id) => {
      const { stage, table } = globalThis.croquis;
      return [...stage.characters.get(id ?? table.actor.value).joints];
    }, actor);
  }

  /** Waits for a condition in the page, never for time. */
  until(condition, argument) {
    return this.page.waitForFunction(condition, argument);
  }

  /** Waits until the last step of the history is called so. */
  undoSays(label) {
    return this.until((wanted) => globalThis.croquis.table.state.value.undo === wanted, label);
  }

  /** Waits until so many entries are in the journal. */
  written(count) {
    return this.page.evaluate(async (wanted) => {
      while ((await globalThis.croquis.table.journal.entries(0)).length < wanted) await new Promise(requestAnimationFrame);
    }, count);
  }

  run(command) {
    return this.page.evaluate((c) => globalThis.croquis.table.run(c).then((change) => change !== null), command);
  }

  /** Waits until nothing is on its way and what came is on the screen. */
  async settled() {
    await this.until(() => globalThis.croquis.table.busy.value === 0 && !globalThis.croquis.table.engine.previewing);
    await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }

  /** The screen position of a joint named by its humanoid bone or its own name. */
  pixel(name) {
    return this.page.evaluate((wanted) => {
      const { stage, table } = globalThis.croquis;
      const view = stage.characters.get(table.actor.value);
      const index = view.info.joints.findIndex((joint) => joint.bone === wanted || joint.name === wanted);
      const { x, y } = stage.rig.project(view.joint(index));
      return { x, y };
    }, name);
  }

  async pen(type, x, y, force) {
    const pressed = type !== 'mouseReleased';
    await this.wire.send('Input.dispatchMouseEvent', {
      type, x, y, button: type === 'mouseMoved' ? 'none' : 'left', buttons: pressed ? 1 : 0, pointerType: 'pen', force, clickCount: type === 'mouseMoved' ? 0 : 1,
    });
  }

  /** Draws through the points with a pen that presses harder as it goes; `during` runs while it is still down. */
  async draw(points, during = async () => {}) {
    await this.pen('mousePressed', points[0].x, points[0].y, 0.2);
    for (let i = 1; i < points.length; ++i) await this.pen('mouseMoved', points[i].x, points[i].y, 0.2 + (0.7 * i) / points.length);
    await during();
    await this.lifted(1, () => this.pen('mouseReleased', points.at(-1).x, points.at(-1).y, 0));
  }

  async tap({ x, y }) {
    await this.pen('mousePressed', x, y, 0.5);
    await this.lifted(1, () => this.pen('mouseReleased', x, y, 0));
  }

  /** Lifts pointers, and waits until the page has seen it and has done what follows: the browser may say sooner that
      it handed the event on. */
  async lifted(count, lift) {
    const seen = await this.page.evaluateHandle((wanted) => {
      const seen = { count: 0, wanted };
      for (const type of ['pointerup', 'pointercancel']) globalThis.addEventListener(type, () => (seen.count += 1));
      return seen;
    }, count);
    await lift();
    await this.until(({ count, wanted }) => count >= wanted, seen);
    await this.settled();
  }

  /** Waits until joints differ from those given by more than `least`, and gives them. */
  async moved(before, least, actor) {
    await this.until(([numbers, wanted, id]) => {
      const { stage, table } = globalThis.croquis;
      const now = stage.characters.get(id ?? table.actor.value)?.joints;
      return now && numbers.some((value, i) => Math.abs(value - now[i]) > wanted);
    }, [before, least, actor]);
    return this.joints(actor);
  }

  /** Puts fingers down, moves them, and lifts them. Without a gesture it is a tap: said to be short, however slow the
      machine is. */
  async fingers(count, gesture) {
    const began = Date.now() / 1000;
    const touch = (type, points, after = 0) => this.wire.send('Input.dispatchTouchEvent', { type, touchPoints: points, ...(gesture ? {} : { timestamp: began + after }) });
    const start = Array.from({ length: count }, (_, i) => ({ x: 380 + 70 * i, y: 260, id: i }));
    await touch('touchStart', start);
    await gesture?.((dx, dy, spread) => touch('touchMove', start.map((p, i) => ({ ...p, x: p.x + dx + (i === 0 ? -spread : spread), y: p.y + dy }))));
    await this.lifted(count, () => touch('touchEnd', [], 0.08));
  }

  async drop(path) {
    const name = path.split('/').at(-1);
    const bytes = readFileSync(path).toString('base64');
    const handle = await this.page.evaluateHandle(([text, file]) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))], file));
      return transfer;
    }, [bytes, name]);
    const before = await this.page.evaluate(() => globalThis.croquis.table.toasts.value.at(-1)?.id ?? 0);
    await this.page.dispatchEvent('body', 'drop', { dataTransfer: handle });
    // Taken as soon as it is there: it goes by itself after a while.
    const toast = await this.page.waitForFunction((last) => globalThis.croquis.table.toasts.value.find((t) => t.id > last), before);
    const told = await toast.jsonValue();
    await this.settled();
    return told;
  }

  async contextIsAlive() {
    const lost = await this.page.evaluate(() => globalThis.croquis.stage.renderer.getContext().isContextLost());
    assert.equal(lost, false, 'the WebGL context is alive');
  }

  async close() {
    await this.contextIsAlive();
    assert.deepEqual(this.faults, [], 'the page reported no fault');
    await this.context.close();
  }
}

/** Points along a C through three places. */
export function arc(from, through, to, count = 24) {
  return Array.from({ length: count }, (_, i) => {
    const t = i / (count - 1);
    const mix = (a, b, c) => (1 - t) * (1 - 2 * t) * a + 4 * t * (1 - t) * b + t * (2 * t - 1) * c;
    return { x: mix(from.x, through.x, to.x), y: mix(from.y, through.y, to.y) };
  });
}

export function distance(a, b) {
  return Math.max(...a.map((value, i) => Math.abs(value - b[i])));
}
