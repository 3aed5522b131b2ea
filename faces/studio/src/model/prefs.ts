// SPDX-License-Identifier: MIT
// What a person likes, kept in this browser: theme, language, hand, which helpers are shown.
import { effect, signal } from '@preact/signals';
import { language, type Language } from '../i18n/strings';

const KEY = 'croquis.preferences';

function stored(): Record<string, unknown> {
  try {
    return JSON.parse(localStorage.getItem(KEY) ?? '{}') as Record<string, unknown>;
  } catch {
    return {};
  }
}

const saved = stored();
const flag = (name: string, fallback: boolean) => signal(typeof saved[name] === 'boolean' ? (saved[name] as boolean) : fallback);

export const dark = flag('dark', matchMedia('(prefers-color-scheme: dark)').matches);
export const leftHanded = flag('leftHanded', false);
export const showSkeleton = flag('showSkeleton', false);
export const showMini = flag('showMini', true);
/** Skin by dual quaternions in place of matrices. */
export const dualQuaternions = flag('dualQuaternions', false);
export const hintSeen = flag('hintSeen', false);

language.value = ((saved['language'] as Language | undefined) ?? (navigator.language.startsWith('fr') ? 'fr' : 'en')) as Language;

effect(() => {
  const all = {
    dark: dark.value,
    leftHanded: leftHanded.value,
    showSkeleton: showSkeleton.value,
    showMini: showMini.value,
    dualQuaternions: dualQuaternions.value,
    hintSeen: hintSeen.value,
    language: language.value,
  };
  try {
    localStorage.setItem(KEY, JSON.stringify(all));
  } catch {
    // A browser that stores nothing still works; it only forgets.
  }
  document.documentElement.dataset['theme'] = dark.value ? 'dark' : 'light';
  document.documentElement.dataset['hand'] = leftHanded.value ? 'left' : 'right';
  document.documentElement.lang = language.value;
});
