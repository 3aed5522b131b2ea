// SPDX-License-Identifier: MIT
import type { LimitPreset, Method, StrokeSettings } from '../engine/protocol';
import { spell } from '../i18n/names';
import { builtinName, t, type StringKey } from '../i18n/strings';
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
          <span class={table.pickedFault.value ? 'fault' : 'quiet'} role="status">
            {table.pickedFault.value ? `${t('notPath')} (${table.pickedFault.value}) ` : ''}
            {t('pickedJoints')}: {table.picked.value.map((j) => spell(table.current.value?.joints[j]?.bone || table.current.value?.joints[j]?.name || '')).join(', ')}
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
        onChange={(method) => change({ method, ...(drawing.direction === 'length' ? { direction: 'auto' } : {}) })}
      />
      <Choice
        label={t('direction')}
        value={drawing.direction ?? 'auto'}
        options={[
          ['auto', t('directionAuto')],
          ['forward', t('directionForward')],
          ['backward', t('directionBackward')],
          ...(drawing.method === 'line' ? [] : [['length', t('directionLength')] as [StrokeSettings['direction'], string]]),
        ]}
        onChange={(direction) => change({ direction })}
      />
      {drawing.method !== 'line' && (
        <Choice
          label={t('plane')}
          value={drawing.plane ?? 'free'}
          options={[
            ['free', t('planeFree')],
            ['ground', t('planeGround')],
          ]}
          onChange={(plane) => change({ plane })}
        />
      )}
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

const BUILTIN = ['mannequin', 'cat', 'snake', 'tree'];

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
      <div class="grid">
        {BUILTIN.map((name) => (
          <Button key={name} onClick={() => void studio.addCharacter(name)}>
            {t('addCharacter', builtinName(name))}
          </Button>
        ))}
      </div>
      {actors.length > 1 && (
        <Choice
          label={t('characters')}
          value={String(actor.id)}
          options={actors.map((a) => [String(a.id), a.name || `#${a.id}`])}
          onChange={(id) => table.take(Number(id))}
        />
      )}
      {actors.length > 1 && <Button onClick={() => void table.run({ name: 'remove_actor', actor: actor.id })}>{t('removeCharacter')}</Button>}
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
