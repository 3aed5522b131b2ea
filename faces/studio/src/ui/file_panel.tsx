// SPDX-License-Identifier: MIT
import { t } from '../i18n/strings';
import type { Studio } from '../studio';
import type { ExportFormat } from '../engine/protocol';
import { chooseFile, dialog, exportFile, exportOpenPose } from './actions';
import { Button, Section } from './controls';

const FORMATS: ExportFormat[] = ['glb', 'vrm', 'bvh', 'svg'];

export function FilePanel({ studio }: { studio: Studio }) {
  return (
    <Section title={t('file')}>
      <div class="grid">
        <Button onClick={() => chooseFile(studio)}>{t('openShort')}</Button>
        <Button onClick={() => void exportFile(studio, 'croquis')}>{t('saveProject')}</Button>
        <Button onClick={() => (dialog.value = 'export')}>{t('exportPng')}</Button>
        {FORMATS.map((format) => (
          <Button key={format} onClick={() => void exportFile(studio, format)}>
            {format.toUpperCase()}
          </Button>
        ))}
        <Button onClick={() => void exportOpenPose(studio)}>OpenPose</Button>
        <Button onClick={() => void studio.newTable()}>{t('newTable')}</Button>
        <Button onClick={() => (dialog.value = 'palette')}>{t('palette')}</Button>
      </div>
      <p class="quiet">{t('dropHere')}</p>
    </Section>
  );
}
