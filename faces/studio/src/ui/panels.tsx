// SPDX-License-Identifier: MIT
import { useEffect, useMemo, useState } from 'preact/hooks';
import type { LimitPreset, Method, StrokeSettings } from '../engine/protocol';
import { spell, t, type StringKey } from '../i18n/strings';
import { dark, leftHanded, showMini, showSkeleton } from '../model/prefs';
import { language } from '../i18n/strings';
import type { Studio } from '../studio';
import { Button, Choice, IconButton, Section, Slider, Switch } from './controls';

type Props = { studio: Studio };

export function LinePanel({ studio }: Props) {
  const { table } = studio;
  const stroke = studio.strokeInHand();
  const settings = { ...table.drawing.value, ...(table.currentStroke.value?.settings ?? {}) };
  const change = (changes: Partial<StrokeSettings>): void => {
    table.drawing.value = { ...table.drawing.value, ...changes };
    if (table.currentStroke.value) void table.run({ name: 'set_stroke', stroke: table.currentStroke.value.id, settings: changes });
  };
  const lines = table.current.value?.body_lines ?? [];
  return (
    <Section title={t('line')} open>
      <Choice
        label={t('bodyLine')}
        value={settings.body_line || 'auto'}
        options={[['auto', t('auto')], ...lines.map((line): [string, string] => [line.name, spell(line.name)])]}
        onChange={(body_line) => change({ body_line, joints: [], alternative: 0 })}
      />
      {table.picked.value.length > 0 && (
        <div class="row">
          <span class="quiet">
            {t('pickedJoints')}: {table.picked.value.map((j) => table.current.value?.joints[j]?.name).join(', ')}
          </span>
          <IconButton icon="close" label={t('clearPicked')} onClick={() => (table.picked.value = [])} />
        </div>
      )}
      <Slider
        label={t('exaggerate')}
        value={settings.exaggerate ?? 1}
        min={0}
        max={2}
        step={0.05}
        onInput={(exaggerate) => stroke && table.preview({ name: 'set_stroke', stroke: stroke.id, settings: { exaggerate } })}
        onChange={(exaggerate) => change({ exaggerate })}
      />
      <Slider label={t('weight')} value={settings.weight ?? 1} min={0.1} max={4} step={0.1} onChange={(weight) => change({ weight })} />
      {stroke && (
        <div class="row">
          <IconButton
            icon="eye"
            label={t(stroke.hidden ? 'show' : 'hide')}
            pressed={!stroke.hidden}
            onClick={() => void table.run({ name: 'set_stroke', stroke: stroke.id, settings: {}, hidden: !stroke.hidden })}
          />
          <IconButton icon="frame" label={t('toItsView')} onClick={() => studio.stage.rig.fromSpec(stroke.camera)} />
          <IconButton icon="trash" label={t('delete')} onClick={() => void table.run({ name: 'delete_stroke', stroke: stroke.id })} />
        </div>
      )}
      {table.currentStroke.value && <p class="quiet">{t('redrawHint')}</p>}
    </Section>
  );
}

export function PosePanel({ studio }: Props) {
  const { table } = studio;
  const actor = table.actor.value;
  const clips = table.current.value?.clips ?? [];
  return (
    <Section title={t('pose')} open>
      <div class="grid">
        <Button onClick={() => void table.run({ name: 'mirror', actor, side: 'both' })}>{t('mirror')}</Button>
        <Button onClick={() => void table.run({ name: 'mirror', actor, side: 'left' })}>{t('leftToRight')}</Button>
        <Button onClick={() => void table.run({ name: 'mirror', actor, side: 'right' })}>{t('rightToLeft')}</Button>
        <Button onClick={() => void table.run({ name: 'reset', actor, joints: [], amount: 1 })}>{t('resetAll')}</Button>
        <Button onClick={() => void studio.copyPose()}>{t('copy')}</Button>
        <Button onClick={() => void studio.pastePose(false)}>{t('paste')}</Button>
        <Button onClick={() => void studio.pastePose(true)}>{t('pasteFlipped')}</Button>
      </div>
      <Slider
        label={t('towardStart')}
        value={0}
        min={0}
        max={1}
        step={0.02}
        onInput={(amount) => table.preview({ name: 'reset', actor, joints: [], amount })}
        onChange={(amount) => void table.run({ name: 'reset', actor, joints: [], amount })}
      />
      {clips.map((clip, i) => (
        <Slider
          key={clip.name}
          label={`${t('frame')}: ${clip.name}`}
          value={0}
          min={0}
          max={Math.max(0, clip.frames - 1)}
          step={1}
          show={(frame) => String(frame)}
          onInput={(frame) => table.preview({ name: 'go_to_frame', actor, clip: i, frame })}
          onChange={(frame) => void table.run({ name: 'go_to_frame', actor, clip: i, frame })}
        />
      ))}
    </Section>
  );
}

const LIMITS: [LimitPreset, StringKey][] = [
  ['anatomical', 'limitsAnatomical'],
  ['dancer', 'limitsDancer'],
  ['cartoon', 'limitsCartoon'],
  ['none', 'limitsNone'],
];

export function RulesPanel({ studio }: Props) {
  const { table } = studio;
  const settings = table.state.value.settings;
  return (
    <Section title={t('rules')}>
      <Choice
        label={t('limits')}
        value={settings.limits}
        options={LIMITS.map(([value, key]) => [value, t(key)])}
        onChange={(limits) => void table.run({ name: 'set_table', settings: { limits } })}
      />
      <Switch label={t('floor')} on={settings.floor} onChange={(floor) => void table.run({ name: 'set_table', settings: { floor } })} />
      <Switch label={t('balance')} on={settings.balance} onChange={(balance) => void table.run({ name: 'set_table', settings: { balance } })} />
      <Switch
        label={t('rootLock')}
        on={settings.root === 'lock'}
        onChange={(on) => void table.run({ name: 'set_table', settings: { root: on ? 'lock' : 'free' } })}
      />
      <Switch
        label={t('moveBody')}
        on={table.drawing.value.move === 'body'}
        onChange={(on) => (table.drawing.value = { ...table.drawing.value, move: on ? 'body' : 'line' })}
      />
    </Section>
  );
}

const METHODS: [Method, StringKey][] = [
  ['line', 'methodLine'],
  ['rotation', 'methodRotation'],
  ['rotation-index', 'methodRotationIndex'],
  ['near', 'methodNear'],
  ['curvilinear', 'methodCurvilinear'],
];

export function AdvancedPanel({ studio }: Props) {
  const { table } = studio;
  const drawing = table.drawing.value;
  const change = (changes: Partial<StrokeSettings>): void => {
    table.drawing.value = { ...drawing, ...changes };
  };
  return (
    <Section title={t('advanced')}>
      <Choice
        label={t('method')}
        value={drawing.method ?? 'line'}
        options={METHODS.map(([value, key]) => [value, t(key)])}
        onChange={(method) => change({ method })}
      />
      <Choice
        label={t('direction')}
        value={drawing.direction ?? 'auto'}
        options={[
          ['auto', t('directionAuto')],
          ['forward', t('directionForward')],
          ['backward', t('directionBackward')],
          ['length', t('directionLength')],
        ]}
        onChange={(direction) => change({ direction })}
      />
      <Choice
        label={t('plane')}
        value={drawing.plane ?? 'free'}
        options={[
          ['free', t('planeFree')],
          ['ground', t('planeGround')],
        ]}
        onChange={(plane) => {
          if (plane === 'ground' && Math.abs(studio.stage.rig.state.elevation) > 1.54) table.tell(t('planeRefused'), 'error');
          else change({ plane });
        }}
      />
      <Choice
        label={t('lengthPolicy')}
        value={drawing.length ?? 'fit'}
        options={[
          ['fit', t('lengthFit')],
          ['scale', t('lengthScale')],
          ['trim', t('lengthTrim')],
          ['extend', t('lengthExtend')],
        ]}
        onChange={(length) => change({ length })}
      />
    </Section>
  );
}

const PROPORTIONS: [string, StringKey, number, number, number][] = [
  ['heads', 'heads', 3, 9, 8],
  ['shoulders', 'shoulders', 0.6, 1.6, 1],
  ['hips', 'hips', 0.6, 1.6, 1],
  ['limbs', 'limbs', 0.7, 1.4, 1],
  ['hands', 'handSize', 0.6, 1.8, 1],
  ['head', 'headSize', 0.7, 1.6, 1],
  ['muscle', 'muscle', 0.6, 1.6, 1],
];

export function CharacterPanel({ studio }: Props) {
  const { table } = studio;
  const { actors } = table.state.value;
  const actor = table.current.value;
  if (!actor) return null;
  return (
    <Section title={t('character')}>
      {actors.length > 1 && (
        <Choice
          label={t('characters')}
          value={String(actor.id)}
          options={actors.map((a) => [String(a.id), a.name || `#${a.id}`])}
          onChange={(id) => (table.actor.value = Number(id))}
        />
      )}
      {actor.licence && (
        <p class="licence">
          <strong>{t('licence')}:</strong> {actor.licence.name || '–'}
          {actor.licence.authors && <> · {t('authors', actor.licence.authors)}</>}
          {Object.entries(actor.licence.terms).map(([term, value]) => (
            <span class="term" key={term}>
              {term}: {value}
            </span>
          ))}
        </p>
      )}
      {actor.oddities.length > 0 && (
        <details class="quiet">
          <summary>{t('moreAbout')}</summary>
          <ul>
            {actor.oddities.map((text) => (
              <li key={text}>{text}</li>
            ))}
          </ul>
        </details>
      )}
      {actor.builtin === 'mannequin' &&
        PROPORTIONS.map(([name, key, min, max, usual]) => (
          <Slider
            key={name}
            label={t(key)}
            value={actor.proportions[name] ?? usual}
            min={min}
            max={max}
            step={name === 'heads' ? 0.25 : 0.05}
            onChange={(value) =>
              void table.run({ name: 'set_proportions', actor: actor.id, proportions: { ...actor.proportions, [name]: value } })
            }
          />
        ))}
    </Section>
  );
}

export function ViewPanel({ studio }: Props) {
  const [, redraw] = useState(0);
  const rig = studio.stage.rig;
  const { views } = studio.table.state.value;
  const light = studio.light.value;
  return (
    <Section title={t('view')}>
      <div class="grid">
        {(['front', 'side', 'back', 'top', 'threeQuarter'] as const).map((view) => (
          <Button key={view} onClick={() => studio.look(view)}>
            {t(view)}
          </Button>
        ))}
        <Button onClick={() => studio.frameSelected()}>{t('frameSelected')}</Button>
      </div>
      <Slider
        label={t('lens')}
        value={rig.state.focal}
        min={12}
        max={200}
        step={1}
        show={(mm) => `${mm} mm`}
        onInput={(focal) => rig.set({ focal })}
        onChange={() => redraw((n) => n + 1)}
      />
      <Switch
        label={t('orthographic')}
        on={rig.state.orthographic}
        onChange={(orthographic) => {
          rig.set({ orthographic });
          redraw((n) => n + 1);
        }}
      />
      <Slider label={t('lightHeading')} value={light.heading} min={-3.14} max={3.14} step={0.05} show={(a) => `${Math.round(a * 57.3)}°`}
        onInput={(heading) => (studio.light.value = { ...light, heading })} onChange={() => {}} />
      <Slider label={t('lightHeight')} value={light.elevation} min={0.1} max={1.5} step={0.05} show={(a) => `${Math.round(a * 57.3)}°`}
        onInput={(elevation) => (studio.light.value = { ...light, elevation })} onChange={() => {}} />
      <div class="row">
        <Button onClick={() => void studio.table.run({ name: 'keep_view', view_name: `${t('view')} ${views.length + 1}`, camera: rig.toSpec() })}>
          {t('keepView')}
        </Button>
      </div>
      {views.map((view, i) => (
        <div class="row" key={view.name}>
          <Button onClick={() => rig.fromSpec(view.camera)}>{view.name}</Button>
          <IconButton icon="trash" label={t('deleteView', view.name)} onClick={() => void studio.table.run({ name: 'delete_view', index: i })} />
        </div>
      ))}
      <Backdrop studio={studio} />
      <Switch label={t('miniView')} on={showMini.value} onChange={(on) => (showMini.value = on)} />
      <Switch label={t('skeleton')} on={showSkeleton.value} onChange={(on) => (showSkeleton.value = on)} />
      <Switch label={t('dark')} on={dark.value} onChange={(on) => (dark.value = on)} />
      <Switch label={t('leftHanded')} on={leftHanded.value} onChange={(on) => (leftHanded.value = on)} />
      <Button onClick={() => (language.value = language.value === 'en' ? 'fr' : 'en')}>{t('language')}</Button>
    </Section>
  );
}

function Backdrop({ studio }: Props) {
  const backdrop = studio.backdrop.value;
  const choose = (): void => {
    const input = document.createElement('input');
    input.type = 'file';
    input.accept = 'image/*';
    input.onchange = () => {
      const file = input.files?.[0];
      if (file) studio.backdrop.value = { url: URL.createObjectURL(file), opacity: 0.5 };
    };
    input.click();
  };
  return (
    <>
      <div class="row">
        <Button onClick={choose}>{t('backdropOpen')}</Button>
        {backdrop && <IconButton icon="trash" label={t('backdropRemove')} onClick={() => (studio.backdrop.value = null)} />}
      </div>
      {backdrop && (
        <Slider label={t('opacity')} value={backdrop.opacity} min={0.05} max={1} step={0.05}
          onInput={(opacity) => (studio.backdrop.value = { ...backdrop, opacity })} onChange={() => {}} />
      )}
    </>
  );
}

interface ShelfPose {
  name: string;
  pose: string;
  kind: 'pose' | 'hand' | 'mine';
}

export function ShelfPanel({ studio }: Props) {
  const { table } = studio;
  const [poses, setPoses] = useState<ShelfPose[]>([]);
  const [kind, setKind] = useState<ShelfPose['kind']>('pose');
  const [strength, setStrength] = useState(1);
  const [flipped, setFlipped] = useState(false);
  const actor = table.actor.value;
  const kept = table.state.value.poses.length;
  const palette = table.current.value?.palette_size;
  useEffect(() => {
    let current = true;
    if (table.current.value) {
      table.engine
        .query<{ poses: ShelfPose[] }>('shelf', { actor })
        .then((answer) => current && setPoses(answer.poses))
        .catch(() => current && setPoses([]));
    }
    return () => {
      current = false;
    };
  }, [actor, kept, palette]);
  const shown = useMemo(() => poses.filter((pose) => pose.kind === kind), [poses, kind]);
  const pictures = useThumbnails(studio, shown, `${actor} ${palette}`);
  return (
    <Section title={t('shelf')} open>
      <div class="tabs" role="group" aria-label={t('shelf')}>
        {(['pose', 'hand', 'mine'] as const).map((k) => (
          <button key={k} type="button" class="tab" aria-pressed={kind === k} onClick={() => setKind(k)}>
            {t(k === 'pose' ? 'shelf' : k === 'hand' ? 'hands' : 'mine')}
          </button>
        ))}
      </div>
      <Slider label={t('strength')} value={strength} min={0} max={1} step={0.05} onChange={setStrength} />
      <Switch label={t('flipped')} on={flipped} onChange={setFlipped} />
      <div class="shelf">
        {shown.map((pose) => (
          <PoseCard key={pose.name} studio={studio} pose={pose} picture={pictures.get(pose.kind + pose.name) ?? ''} strength={strength} flipped={flipped} />
        ))}
      </div>
      {kind === 'mine' && (
        <Button
          onClick={() => {
            const name = prompt(t('nameOfPose'), `${t('pose')} ${kept + 1}`);
            if (name) void table.run({ name: 'keep_pose', actor, pose_name: name });
          }}
        >
          {t('keepPose')}
        </Button>
      )}
    </Section>
  );
}

function PoseCard({ studio, pose, picture, strength, flipped }: Props & { pose: ShelfPose; picture: string; strength: number; flipped: boolean }) {
  const apply = () => void studio.table.run({ name: 'apply_pose', actor: studio.table.actor.value, pose: pose.pose, strength, flipped });
  return (
    <button type="button" class="pose-card" onClick={apply} title={pose.name}>
      {picture ? <img src={picture} alt="" style={flipped ? 'transform: scaleX(-1)' : ''} /> : <span class="blank" />}
      <span>{pose.name}</span>
    </button>
  );
}

/** Pictures of the poses, a few at a time so that the table stays quick; none are made while the pen is down. */
function useThumbnails(studio: Studio, poses: ShelfPose[], key: string): Map<string, string> {
  const [pictures, setPictures] = useState(new Map<string, string>());
  useEffect(() => {
    let current = true;
    const made = new Map<string, string>();
    const work = async (): Promise<void> => {
      for (let i = 0; i < poses.length && current; i += 6) {
        while (studio.gestures.path !== 'idle' && current) await new Promise((later) => setTimeout(later, 200));
        const some = poses.slice(i, i + 6);
        const urls = await studio.thumbnails(some.map((pose) => ({ pose: pose.pose, hand: pose.kind === 'hand' })));
        some.forEach((pose, k) => made.set(pose.kind + pose.name, urls[k] ?? ''));
        if (current) setPictures(new Map(made));
        await new Promise((later) => setTimeout(later, 30));
      }
    };
    work().catch(() => {});
    return () => {
      current = false;
    };
  }, [poses, key]);
  return pictures;
}
