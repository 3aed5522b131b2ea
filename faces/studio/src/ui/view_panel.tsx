// SPDX-License-Identifier: MIT
import { useState } from 'preact/hooks';
import { language, t } from '../i18n/strings';
import { dark, dualQuaternions, leftHanded, showMini, showSkeleton } from '../model/prefs';
import type { Studio } from '../studio';
import { Button, IconButton, Section, Slider, Switch } from './controls';

type Props = { studio: Studio };

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
      <Switch label={t('dualQuaternions')} on={dualQuaternions.value} onChange={(on) => (dualQuaternions.value = on)} />
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
