// SPDX-License-Identifier: MIT
import { useEffect, useLayoutEffect, useRef, useState } from 'preact/hooks';
import { named, spell } from '../i18n/names';
import { t } from '../i18n/strings';
import { hintSeen, leftHanded, showMini } from '../model/prefs';
import type { Studio } from '../studio';
import type { Axis, ToolName } from '../tools/tool';
import { chooseFile, dialog, exportFile, type Action } from './actions';
import { Button, IconButton } from './controls';
import { ExportPicture, Palette } from './dialogs';
import type { IconName } from './icons';
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
  useLayoutEffect(() => studio.setPanels(panelsOpen), [panelsOpen, leftHanded.value]);
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
      <IconButton icon="undo" label={undo ? t('undoLabel', named(undo)) : t('undo')} disabled={!undo && !studio.table.earlier.value} onClick={() => void studio.table.undo()} />
      <IconButton icon="redo" label={redo ? t('redoLabel', named(redo)) : t('redo')} disabled={!redo} onClick={() => void studio.table.redo()} />
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
      <Button onClick={() => void table.run({ name: 'reset', actor: actor.id, joints: studio.limbOf(joint), amount: 1 })}>{t('resetShort')}</Button>
      {studio.tool.value === 'rotate' &&
        (['x', 'y', 'z'] as Axis[]).map((axis) => (
          <button key={axis} type="button" class="chip axis" aria-pressed={studio.axis.value === axis} aria-label={t('holdAxis', axis.toUpperCase())} title={t('holdAxis', axis.toUpperCase())} onClick={() => studio.holdAxis(axis)}>
            {axis.toUpperCase()}
          </button>
        ))}
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
