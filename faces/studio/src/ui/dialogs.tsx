// SPDX-License-Identifier: MIT
// What opens over the table: the list of all commands, the export of a picture.
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { t } from '../i18n/strings';
import type { Studio } from '../studio';
import { dialog, download, type Action } from './actions';
import { Switch } from './controls';
import { Icon } from './icons';

export function Palette({ actions }: { actions: Action[] }) {
  const [text, setText] = useState('');
  const [at, setAt] = useState(0);
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
        autofocus
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

export function ExportPicture({ studio }: { studio: Studio }) {
  const canvas = studio.stage.canvas;
  const [width, setWidth] = useState(canvas.clientWidth * 2);
  const [height, setHeight] = useState(canvas.clientHeight * 2);
  const [transparent, setTransparent] = useState(false);
  const [strokes, setStrokes] = useState(true);
  const [backdrop, setBackdrop] = useState(false);
  const save = async (): Promise<void> => {
    dialog.value = 'none';
    await download(await studio.pictures.png({ width, height, transparent, strokes, backdrop }), 'croquis.png', studio);
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
      {studio.backdrop.value && <Switch label={t('withBackdrop')} on={backdrop} onChange={setBackdrop} />}
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

/** The browser's own modal dialog: it keeps the focus inside and closes on Escape. It opens before the next key can
    arrive, so that a fast typist loses no letter, and gives the focus back to where it was. */
function Modal({ label, children }: { label: string; children: preact.ComponentChildren }) {
  const element = useRef<HTMLDialogElement>(null);
  useLayoutEffect(() => {
    const box = element.current!;
    const closed = (): void => void (dialog.value = 'none');
    box.addEventListener('cancel', closed); // Escape: at once, so that the next key is the table's again
    box.addEventListener('close', closed);
    box.showModal();
    return () => {
      box.removeEventListener('close', closed); // it tells of it later, when another may be open
      box.close();
    };
  }, []);
  return (
    <dialog
      ref={element}
      aria-label={label}
      onClick={(e) => {
        if (e.target === element.current) dialog.value = 'none';
      }}
    >
      {children}
    </dialog>
  );
}
