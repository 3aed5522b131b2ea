// SPDX-License-Identifier: MIT
import { effect } from '@preact/signals';
import { render } from 'preact';
import { startEngine } from './engine/client';
import { t } from './i18n/strings';
import { openJournal, type NoStorage } from './model/journal';
import './model/prefs';
import { Studio } from './studio';
import type { PointerSample } from './tools/gestures';
import { actionFor, dialog, keyOf, makeActions } from './ui/actions';
import { App } from './ui/app';
import { startMeter } from './ui/meter';
import './ui/style.css';
import './ui/places.css';

const element = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;

function sampleOf(event: PointerEvent, space: boolean): PointerSample {
  const frame = element('table').getBoundingClientRect();
  return {
    id: event.pointerId,
    type: event.pointerType,
    button: event.button,
    x: event.clientX - frame.left,
    y: event.clientY - frame.top,
    time: event.timeStamp,
    pressure: event.pressure || 0.5,
    alt: event.altKey,
    shift: event.shiftKey,
    space,
  };
}

function listen(studio: Studio): void {
  const canvas = element<HTMLCanvasElement>('table');
  const { gestures } = studio;
  let space = false;
  const sample = (event: PointerEvent) => sampleOf(event, space);
  // The table shows that it has the focus to those who walk with Tab, not to those who draw.
  window.addEventListener('pointerdown', () => delete document.documentElement.dataset['keys'], true);
  canvas.addEventListener('pointerdown', (event) => {
    if (gestures.pointerDown(sample(event))) canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
  });
  canvas.addEventListener('pointermove', (event) => {
    const all = event.getCoalescedEvents?.() ?? [];
    gestures.pointerMove(sample(event), (all.length > 0 ? all : [event]).map(sample));
  });
  canvas.addEventListener('pointerup', (event) => gestures.pointerUp(sample(event)));
  canvas.addEventListener('pointercancel', (event) => gestures.pointerCancel(sample(event)));
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    gestures.wheel(event.deltaY);
  }, { passive: false });

  const actions = makeActions(studio);
  window.addEventListener('keydown', (event) => {
    const inText = event.target instanceof HTMLInputElement && !/range|checkbox/.test(event.target.type);
    if (event.key === ' ' && (event.target === canvas || event.target === document.body)) {
      space = true;
      event.preventDefault();
    }
    if (event.key === 'Escape') gestures.cancel();
    if (event.key === 'Tab') document.documentElement.dataset['keys'] = 'true';
    const action = actionFor(actions, keyOf(event), studio.tool.value);
    const plain = !event.ctrlKey && !event.metaKey && !event.altKey;
    if (!action || inText || dialog.value !== 'none' || (plain && event.target instanceof HTMLSelectElement)) return;
    event.preventDefault();
    void action.run();
  });
  window.addEventListener('keyup', (event) => {
    if (event.key === ' ') space = false;
  });
  window.addEventListener('blur', () => (space = false));

  window.addEventListener('dragover', (event) => {
    event.preventDefault();
    document.body.classList.add('dropping');
  });
  window.addEventListener('dragleave', (event) => {
    if (!event.relatedTarget) document.body.classList.remove('dropping');
  });
  window.addEventListener('drop', async (event) => {
    event.preventDefault();
    document.body.classList.remove('dropping');
    for (const file of event.dataTransfer?.files ?? []) await studio.openFile(file);
  });

  new ResizeObserver(() => studio.resize(canvas.clientWidth, canvas.clientHeight)).observe(canvas);
  render(<App studio={studio} actions={actions} />, element('panels'));
}

async function start(): Promise<void> {
  const query = new URLSearchParams(location.search);
  const backdrop = element<HTMLDivElement>('backdrop');
  element('loading').textContent = t('loading');
  effect(() => element('table').setAttribute('aria-label', t('canvasLabel')));
  const engine = startEngine(); // it gets ready while the rest does
  let studio: Studio | null = null;
  let unheard: NoStorage | null = null;
  const journal = await openJournal((why) => {
    if (studio) studio.table.tell(t(why), 'error');
    else unheard = why;
  });
  try {
    studio = new Studio(engine, journal, element('table'), element('glass'), query.get('quality') === 'draft' ? 'draft' : 'full');
  } catch (error) {
    element('loading').textContent = `${t('noWebgl')} ${(error as Error).message}`;
    return;
  }
  const ready = studio;
  if (unheard) ready.table.tell(t(unheard), 'error');
  effect(() => {
    const image = ready.backdrop.value;
    backdrop.style.backgroundImage = image ? `url("${image.url}")` : '';
    backdrop.style.opacity = String(image?.opacity ?? 0);
  });
  listen(ready);
  ready.resize(element('table').clientWidth, element('table').clientHeight);
  // Stories and people who script the page look in through this window.
  Object.assign(window, { croquis: ready });
  await ready.start();
  element('loading').hidden = true;
  performance.mark('croquis-ready');
  document.documentElement.dataset['ready'] = 'true';
  if (query.has('perf')) startMeter(ready, element('panels'));
  if ('serviceWorker' in navigator && import.meta.env.PROD) await navigator.serviceWorker.register('./service-worker.js');
}

void start();
