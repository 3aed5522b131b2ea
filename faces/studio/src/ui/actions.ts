// SPDX-License-Identifier: MIT
// Everything that can be done, once: the palette lists it, the keys call it, buttons share it.
import { signal } from '@preact/signals';
import type { ExportFormat } from '../engine/protocol';
import { builtinName, t, type StringKey } from '../i18n/strings';
import { dark, leftHanded, showMini, showSkeleton } from '../model/prefs';
import { language } from '../i18n/strings';
import type { Studio } from '../studio';
import type { Axis, ToolName } from '../tools/tool';

export interface Action {
  id: string;
  label: () => string;
  /** As a person reads it: 'Ctrl+Z'. The first is shown; all work. */
  keys: string[];
  /** Its keys mean this only while that tool is in hand; there they go before those of the whole table. */
  tool?: ToolName;
  run: () => void | Promise<void>;
}

export type Dialog = 'none' | 'palette' | 'export' | 'menu' | 'licence';
export const dialog = signal<Dialog>('none');

export async function download(blob: Blob | null, name: string, studio: Studio): Promise<void> {
  if (!blob) return;
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  studio.table.tell(t('exported', name));
}

export async function exportFile(studio: Studio, format: ExportFormat): Promise<void> {
  const name = (studio.table.current.value?.name || 'croquis').replace(/[^\p{L}\p{N}_-]+/gu, '_');
  const extension = format === 'openpose' ? 'json' : format;
  await download(await studio.export(format), `${name}.${extension}`, studio);
}

/** Two files: the figure as a picture, and its points as JSON. */
export async function exportOpenPose(studio: Studio): Promise<void> {
  const json = await studio.export('openpose');
  if (!json) return; // it was told why
  await download(await studio.pictures.openPose(), 'openpose.png', studio);
  await download(json, 'openpose.json', studio);
}

export function chooseFile(studio: Studio): void {
  const input = document.createElement('input');
  input.type = 'file';
  input.accept = '.glb,.gltf,.vrm,.bvh,.croquis,.json,image/*';
  input.onchange = () => {
    const file = input.files?.[0];
    if (file) void studio.openFile(file);
  };
  input.click();
}

const action = (id: string, label: StringKey | (() => string), keys: string[], run: Action['run']): Action => ({
  id,
  label: typeof label === 'string' ? () => t(label) : label,
  keys,
  run,
});

/** History, tools, lines. */
const lineActions = (studio: Studio): Action[] => {
  const { table } = studio;
  return [
    action('undo', 'undo', ['Ctrl+Z'], table.undo),
    action('redo', 'redo', ['Ctrl+Shift+Z', 'Ctrl+Y'], table.redo),
    action('draw', 'draw', ['D'], () => studio.choose('draw')),
    action('drag', 'drag', ['G'], () => studio.choose('drag')),
    action('rotate', 'rotate', ['R'], () => studio.choose('rotate')),
    action('select', 'select', ['Q'], () => studio.choose('select')),
    ...(['x', 'y', 'z'] as Axis[]).map((axis): Action => ({
      ...action(`axis.${axis}`, () => t('holdAxis', axis.toUpperCase()), [axis.toUpperCase()], () => studio.holdAxis(axis)),
      tool: 'rotate',
    })),
    action('next', 'nextAlternative', [']'], () => studio.cycle(1)),
    action('previous', 'previousAlternative', ['['], () => studio.cycle(-1)),
    action('delete', 'delete', ['Delete', 'X'], () => {
      const stroke = studio.strokeInHand();
      if (stroke) void table.run({ name: 'delete_stroke', stroke: stroke.id });
    }),
    action('hide', 'hide', ['H'], () => {
      const stroke = studio.strokeInHand();
      if (stroke) void table.run({ name: 'set_stroke', stroke: stroke.id, settings: {}, hidden: !stroke.hidden });
    }),
    action('showAll', 'showAll', ['Alt+H'], async () => {
      const hidden = table.state.value.strokes.filter((stroke) => stroke.hidden);
      for (const stroke of hidden) await table.run({ name: 'set_stroke', stroke: stroke.id, settings: {}, hidden: false });
    }),
  ];
};

/** The character in hand. */
const poseActions = (studio: Studio): Action[] => {
  const { table } = studio;
  const actor = () => table.actor.value;
  const joint = () => table.joint.value;
  return [
    action('mirror', 'mirror', ['M'], () => void table.run({ name: 'mirror', actor: actor(), side: 'both' })),
    action('leftToRight', 'leftToRight', ['Shift+M'], () => void table.run({ name: 'mirror', actor: actor(), side: 'left' })),
    action('rightToLeft', 'rightToLeft', ['Alt+M'], () => void table.run({ name: 'mirror', actor: actor(), side: 'right' })),
    action('copy', 'copy', ['Ctrl+C'], () => studio.copyPose()),
    action('paste', 'paste', ['Ctrl+V'], () => studio.pastePose(false)),
    action('pasteFlipped', 'pasteFlipped', ['Ctrl+Shift+V'], () => studio.pastePose(true)),
    action('resetLimb', 'resetLimb', ['Alt+R'], () => {
      const from = joint();
      if (from !== null) void table.run({ name: 'reset', actor: actor(), joints: studio.limbOf(from), amount: 1 });
    }),
    action('resetAll', 'resetAll', ['Alt+G'], () => void table.run({ name: 'reset', actor: actor(), joints: [], amount: 1 })),
    action('relax', 'towardStart', ['Alt+E'], () => void table.run({ name: 'reset', actor: actor(), joints: [], amount: 0.2 })),
    action('pin', 'pin', ['P'], () => {
      const on = joint();
      const pinned = table.current.value?.pins.some((pin) => pin.joint === on) ?? false;
      if (on !== null) void table.run({ name: 'pin', actor: actor(), joint: on, on: !pinned, with_rotation: false });
    }),
  ];
};

/** What is seen, and how. */
const viewActions = (studio: Studio): Action[] => {
  const { table } = studio;
  return [
    action('front', 'front', ['1', 'Numpad1'], () => studio.look('front')),
    action('back', 'back', ['Ctrl+1', 'Ctrl+Numpad1'], () => studio.look('back')),
    action('side', 'side', ['3', 'Numpad3'], () => studio.look('side')),
    action('top', 'top', ['7', 'Numpad7'], () => studio.look('top')),
    action('otherSide', 'otherSide', ['Ctrl+3', 'Ctrl+Numpad3'], () => studio.look('side', true)),
    action('below', 'below', ['Ctrl+7', 'Ctrl+Numpad7'], () => studio.look('top', true)),
    action('threeQuarter', 'threeQuarter', ['9', 'Numpad9'], () => studio.look('threeQuarter')),
    action('ortho', 'orthographic', ['5', 'Numpad5'], () => studio.stage.rig.set({ orthographic: !studio.stage.rig.state.orthographic })),
    action('frame', 'frameSelected', ['.', 'NumpadDecimal', 'F'], () => studio.frameSelected()),
    action('toView', 'toItsView', ['0', 'Numpad0'], () => {
      const stroke = studio.strokeInHand();
      if (stroke) studio.stage.rig.fromSpec(stroke.camera);
    }),
    action('keepView', 'keepView', [], () => {
      const count = table.state.value.views.length + 1;
      void table.run({ name: 'keep_view', view_name: `${t('view')} ${count}`, camera: studio.stage.rig.toSpec() });
    }),
    action('skeleton', 'skeleton', ['K'], () => void (showSkeleton.value = !showSkeleton.value)),
    action('mini', 'miniView', [], () => void (showMini.value = !showMini.value)),
    action('dark', 'dark', [], () => void (dark.value = !dark.value)),
    action('hand', 'leftHanded', [], () => void (leftHanded.value = !leftHanded.value)),
    action('language', 'language', [], () => void (language.value = language.value === 'en' ? 'fr' : 'en')),
  ];
};

/** What comes and goes; the list of all this. */
const fileActions = (studio: Studio): Action[] => {
  const { table } = studio;
  const exports: ExportFormat[] = ['glb', 'gltf', 'vrm', 'bvh', 'svg'];
  return [
    action('open', 'open', ['Ctrl+O'], () => chooseFile(studio)),
    action('save', 'saveProject', ['Ctrl+S'], () => exportFile(studio, 'croquis')),
    action('png', 'exportPng', ['Ctrl+E'], () => void (dialog.value = 'export')),
    ...exports.map((format) => action(`export.${format}`, () => t('exportAs', format.toUpperCase()), [], () => exportFile(studio, format))),
    ...['mannequin', 'cat', 'snake', 'tree'].map((name) =>
      action(`add.${name}`, () => t('addCharacter', builtinName(name)), [], () => studio.addCharacter(name)),
    ),
    action('remove', 'removeCharacter', [], () => void table.run({ name: 'remove_actor', actor: table.actor.value })),
    action('new', 'newTable', [], () => studio.newTable()),
    action('openpose', 'exportOpenPose', [], () => exportOpenPose(studio)),
    action('palette', 'palette', ['Ctrl+K', 'F3'], () => void (dialog.value = 'palette')),
  ];
};

export function makeActions(studio: Studio): Action[] {
  return [...lineActions(studio), ...poseActions(studio), ...viewActions(studio), ...fileActions(studio)];
}

/** 'Ctrl+Shift+Z' for a key event: letters and signs by what they mean, digits and the number pad by where they are. */
export function keyOf(event: KeyboardEvent): string {
  const { code, key } = event;
  const composed = event.getModifierState('AltGraph'); // '[' on many keyboards: no Ctrl and no Alt is meant
  const digit = /^Digit(\d)$/.exec(code)?.[1];
  const named = code.startsWith('Numpad') ? code : digit && !composed ? digit : key.length === 1 ? key.toUpperCase() : key;
  const shifted = event.shiftKey && /^[A-Z]$|^[A-Za-z]{2,}/.test(named);
  const modifiers = composed ? [] : [event.ctrlKey || event.metaKey ? 'Ctrl' : '', event.altKey ? 'Alt' : '', shifted ? 'Shift' : ''];
  return [...modifiers, named].filter(Boolean).join('+');
}

/** The action that a key means with that tool in hand. */
export function actionFor(actions: Action[], key: string, tool: ToolName): Action | undefined {
  const known = actions.filter((action) => action.keys.includes(key));
  return known.find((action) => action.tool === tool) ?? known.find((action) => action.tool === undefined);
}
