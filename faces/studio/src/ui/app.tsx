// SPDX-License-Identifier: MIT
import { useEffect, useRef, useState } from 'preact/hooks';
import { spell, t } from '../i18n/strings';
import { hintSeen, leftHanded, showMini } from '../model/prefs';
import type { Studio } from '../studio';
import type { ToolName } from '../tools/tool';
import { chooseFile, dialog, download, exportFile, type Action } from './actions';
import { Button, IconButton, Switch } from './controls';
import { Icon, type IconName } from './icons';
import { FilePanel } from './file_panel';
import { AdvancedPanel, CharacterPanel, LinePanel, PosePanel, RulesPanel } from './panels';
import { ShelfPanel } from './shelf_panel';
import { ViewPanel } from './view_panel';

type Props = { studio: Studio; actions: Action[] };

const TOOLS: [ToolName, IconName][] = [
  ['draw', 'draw'],
  ['drag', 'drag'],
  ['rotate', 'rotate'],
  ['select', 'select'],
];

export function App({ studio, actions }: Props) {
  const [panelsOpen, setPanelsOpen] = useState(matchMedia('(min-width: 900px)').matches);
  useEffect(() => {
    studio.setInsets(panelsOpen);
  }, [panelsOpen, leftHanded.value]);
  return (
    <>
      <ToolBar studio={studio} />
      <TopBar studio={studio} panelsOpen={panelsOpen} togglePanels={() => setPanelsOpen(!panelsOpen)} />
      <Hint studio={studio} />
      <JointBar studio={studio} />
      <Chips studio={studio} />
      {showMini.value && <MiniView studio={studio} />}
      <aside class="panels" aria-label={t('menu')} hidden={!panelsOpen}>
        <LinePanel studio={studio} />
        <ShelfPanel studio={studio} />
        <PosePanel studio={studio} />
        <RulesPanel studio={studio} />
        <CharacterPanel studio={studio} />
        <ViewPanel studio={studio} />
        <AdvancedPanel studio={studio} />
        <FilePanel studio={studio} />
      </aside>
      <Toasts studio={studio} />
      {dialog.value === 'palette' && <Palette actions={actions} />}
      {dialog.value === 'export' && <ExportPicture studio={studio} />}
    </>
  );
}

function ToolBar({ studio }: { studio: Studio }) {
  return (
    <nav class={`tools${leftHanded.value ? ' right' : ''}`} aria-label={t('tools')}>
      {TOOLS.map(([tool, icon]) => (
        <IconButton key={tool} icon={icon} label={t(tool)} pressed={studio.tool.value === tool} onClick={() => studio.choose(tool)} />
      ))}
    </nav>
  );
}

function TopBar({ studio, panelsOpen, togglePanels }: { studio: Studio; panelsOpen: boolean; togglePanels: () => void }) {
  const { undo, redo } = studio.table.state.value;
  return (
    <header class="top">
      <h1>{t('appName')}</h1>
      <IconButton icon="undo" label={undo ? t('undoLabel', undo) : t('undo')} disabled={!undo} onClick={() => void studio.table.undo()} />
      <IconButton icon="redo" label={redo ? t('redoLabel', redo) : t('redo')} disabled={!redo} onClick={() => void studio.table.redo()} />
      <span class="space" />
      <IconButton icon="mirror" label={t('mirror')} onClick={() => void studio.table.run({ name: 'mirror', actor: studio.table.actor.value, side: 'both' })} />
      <IconButton icon="frame" label={t('frameSelected')} onClick={() => studio.frameSelected()} />
      <IconButton icon="open" label={t('open')} onClick={() => chooseFile(studio)} />
      <IconButton icon="keep" label={t('saveProject')} onClick={() => void exportFile(studio, 'croquis')} />
      <IconButton icon="search" label={t('palette')} onClick={() => (dialog.value = 'palette')} />
      <IconButton icon="menu" label={t('menu')} pressed={panelsOpen} onClick={togglePanels} />
    </header>
  );
}

function Hint({ studio }: { studio: Studio }) {
  const drawn = studio.table.state.value.strokes.length > 0 || studio.drawingNow.value;
  useEffect(() => {
    if (drawn) hintSeen.value = true;
  }, [drawn]);
  if (drawn || studio.tool.value !== 'draw') return null;
  return (
    <div class="hint" aria-live="polite">
      <strong>{t('hint')}</strong>
      {!hintSeen.value && <span>{t('hintMore')}</span>}
    </div>
  );
}

/** What can be done with the joint in hand. */
function JointBar({ studio }: { studio: Studio }) {
  const { table } = studio;
  const joint = table.joint.value;
  const actor = table.current.value;
  if (joint === null || !actor || studio.tool.value === 'draw') return null;
  const pinned = actor.pins.some((pin) => pin.joint === joint);
  return (
    <div class="joint-bar" role="group" aria-label={t('jointTools')}>
      <span class="quiet">{spell(actor.joints[joint]?.bone || actor.joints[joint]?.name || '')}</span>
      <Button onClick={() => void table.run({ name: 'pin', actor: actor.id, joint, on: !pinned, with_rotation: false })}>{t(pinned ? 'unpin' : 'pin')}</Button>
      <Button onClick={() => void table.run({ name: 'reset', actor: actor.id, joints: studio.limbOf(joint), amount: 1 })}>{t('resetLimb')}</Button>
      <IconButton icon="close" label={t('close')} onClick={() => (table.joint.value = null)} />
    </div>
  );
}

/** Which line was meant: the reading in hand and the others, a tap away. */
function Chips({ studio }: { studio: Studio }) {
  const { table } = studio;
  const stroke = studio.strokeInHand();
  const isAbout = studio.drawingNow.value || (stroke !== null && stroke.id === table.solvedStroke.value);
  const solved = isAbout ? table.solved.value : null;
  if (!solved && !stroke) return null;
  return (
    <div class="chips" role="group" aria-label={t('lineGuess')}>
      <IconButton icon="previous" label={t('previousAlternative')} onClick={() => void studio.cycle(-1)} />
      <div class="chip-list">
        {!solved && stroke && <span class="chip on">{spell(stroke.line.name)}</span>}
        {solved?.alternatives.map((alternative, i) => (
          <button key={alternative.label + i} type="button" class="chip" aria-pressed={i === solved.chosen} onClick={() => void studio.chooseAlternative(i)}>
            {spell(alternative.label)}
          </button>
        ))}
      </div>
      <IconButton icon="next" label={t('nextAlternative')} onClick={() => void studio.cycle(1)} />
      {solved && !/^(ok|stopped)/.test(solved.status) && <span class="status">{solved.status}</span>}
    </div>
  );
}

/** Only the frame: the stage draws the view itself, into the part of its own canvas that lies under this one. */
function MiniView({ studio }: { studio: Studio }) {
  const frame = useRef<HTMLDivElement>(null);
  useEffect(() => {
    studio.stage.setMini(() => {
      const box = frame.current?.getBoundingClientRect();
      return box ? { x: box.x + 2, y: box.y + 2, width: box.width - 4, height: box.height - 4 } : null;
    });
    return () => studio.stage.setMini(null);
  }, []);
  return <div ref={frame} class="mini" role="img" aria-label={t('miniView')} />;
}

function Toasts({ studio }: { studio: Studio }) {
  return (
    <div class="toasts" aria-live="polite">
      {studio.table.toasts.value.map((toast) => (
        <div key={toast.id} class={`toast ${toast.kind}`} role={toast.kind === 'error' ? 'alert' : 'status'}>
          <span>{toast.text}</span>
          <IconButton icon="close" label={t('close')} onClick={() => studio.table.dismiss(toast.id)} />
        </div>
      ))}
    </div>
  );
}

function Palette({ actions }: { actions: Action[] }) {
  const [text, setText] = useState('');
  const [at, setAt] = useState(0);
  const input = useRef<HTMLInputElement>(null);
  useEffect(() => input.current?.focus(), []);
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  const found = actions.filter((a) => words.every((word) => `${a.label()} ${a.id}`.toLowerCase().includes(word)));
  const run = (action: Action | undefined): void => {
    dialog.value = 'none';
    void action?.run();
  };
  const key = (event: KeyboardEvent): void => {
    if (event.key === 'ArrowDown') setAt(Math.min(found.length - 1, at + 1));
    else if (event.key === 'ArrowUp') setAt(Math.max(0, at - 1));
    else if (event.key === 'Enter') run(found[at]);
    else return;
    event.preventDefault();
  };
  return (
    <Modal label={t('palette')}>
      <input
        ref={input}
        type="text"
        class="palette-input"
        role="combobox"
        aria-expanded="true"
        aria-controls="palette-list"
        {...(found[at] ? { 'aria-activedescendant': `palette-${found[at].id}` } : {})}
        aria-label={t('paletteSearch')}
        placeholder={t('paletteSearch')}
        value={text}
        onInput={(e) => {
          setText(e.currentTarget.value);
          setAt(0);
        }}
        onKeyDown={key}
      />
      <ul id="palette-list" class="palette" role="listbox" aria-label={t('palette')}>
        {found.map((action, i) => (
          <li key={action.id} id={`palette-${action.id}`} role="option" aria-selected={i === at} onClick={() => run(action)}>
            <span>{action.label()}</span>
            {action.keys[0] && <kbd>{action.keys[0]}</kbd>}
          </li>
        ))}
      </ul>
    </Modal>
  );
}

function ExportPicture({ studio }: { studio: Studio }) {
  const canvas = studio.stage.canvas;
  const [width, setWidth] = useState(canvas.clientWidth * 2);
  const [height, setHeight] = useState(canvas.clientHeight * 2);
  const [transparent, setTransparent] = useState(false);
  const [strokes, setStrokes] = useState(true);
  const save = async (): Promise<void> => {
    dialog.value = 'none';
    await download(await studio.picture(width, height, transparent, strokes), 'croquis.png', studio);
  };
  const size = (label: string, value: number, set: (v: number) => void) => (
    <label class="field">
      <span>{label}</span>
      <input type="number" min={16} max={8192} value={value} onInput={(e) => set(Math.min(8192, Math.max(16, Number(e.currentTarget.value) || 16)))} />
    </label>
  );
  return (
    <Modal label={t('exportPng')}>
      <h2>{t('exportPng')}</h2>
      {size(t('width'), width, setWidth)}
      {size(t('height'), height, setHeight)}
      <Switch label={t('transparent')} on={transparent} onChange={setTransparent} />
      <Switch label={t('withStrokes')} on={strokes} onChange={setStrokes} />
      <div class="row end">
        <button type="button" class="button" onClick={() => (dialog.value = 'none')}>
          {t('cancel')}
        </button>
        <button type="button" class="button primary" onClick={() => void save()}>
          <Icon name="keep" /> {t('exportTitle')}
        </button>
      </div>
    </Modal>
  );
}

/** The browser's own modal dialog: it keeps the focus inside and closes on Escape. */
function Modal({ label, children }: { label: string; children: preact.ComponentChildren }) {
  const element = useRef<HTMLDialogElement>(null);
  useEffect(() => element.current?.showModal(), []);
  return (
    <dialog
      ref={element}
      aria-label={label}
      onClose={() => (dialog.value = 'none')}
      onClick={(e) => {
        if (e.target === element.current) dialog.value = 'none';
      }}
    >
      {children}
    </dialog>
  );
}
