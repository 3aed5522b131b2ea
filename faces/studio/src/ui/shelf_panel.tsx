// SPDX-License-Identifier: MIT
import { useEffect, useMemo, useState } from 'preact/hooks';
import { named } from '../i18n/names';
import { t } from '../i18n/strings';
import { forgetPose, keepPose, keptPoses, posesAsFile } from '../model/pose_shelf';
import type { Studio } from '../studio';
import { download } from './actions';
import { Button, IconButton, Section, Slider, Switch } from './controls';

type Props = { studio: Studio };

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
  const mine = keptPoses.value;
  const shown = useMemo(
    () => [...poses.filter((pose) => pose.kind === kind), ...(kind === 'mine' ? mine.map((pose): ShelfPose => ({ ...pose, kind: 'mine' })) : [])],
    [poses, kind, mine],
  );
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
      {kind === 'mine' && <Mine studio={studio} />}
    </Section>
  );
}

/** Poses kept in this browser: name the present one, forget one, save them all as a file. */
function Mine({ studio }: Props) {
  const [name, setName] = useState('');
  const poses = keptPoses.value;
  const keep = async (): Promise<void> => {
    const { pose } = await studio.table.engine.query<{ pose: string }>('pose', { actor: studio.table.actor.value });
    keepPose({ name: name.trim() || `${t('pose')} ${poses.length + 1}`, pose });
    setName('');
  };
  return (
    <>
      <label class="field">
        <span>{t('nameOfPose')}</span>
        <input type="text" value={name} onInput={(e) => setName(e.currentTarget.value)} />
      </label>
      <Button onClick={() => void keep()}>{t('keepPose')}</Button>
      {poses.map((pose) => (
        <div class="row between" key={pose.name}>
          <span>{pose.name}</span>
          <IconButton icon="trash" label={t('forgetPose', pose.name)} onClick={() => forgetPose(pose.name)} />
        </div>
      ))}
      {poses.length > 0 && (
        <Button onClick={() => void download(new Blob([posesAsFile()], { type: 'application/json' }), 'croquis-poses.json', studio)}>
          {t('savePoses')}
        </Button>
      )}
    </>
  );
}

function PoseCard({ studio, pose, picture, strength, flipped }: Props & { pose: ShelfPose; picture: string; strength: number; flipped: boolean }) {
  const label = pose.kind === 'mine' ? pose.name : named(pose.name);
  const apply = () => void studio.table.run({ name: 'apply_pose', actor: studio.table.actor.value, pose: pose.pose, strength, flipped });
  return (
    <button type="button" class="pose-card" onClick={apply} title={label}>
      {picture ? <img src={picture} alt="" style={flipped ? 'transform: scaleX(-1)' : ''} /> : <span class="blank" />}
      <span>{label}</span>
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
        const urls = await studio.pictures.thumbnails(some.map((pose) => ({ pose: pose.pose, hand: pose.kind === 'hand' })));
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
