// SPDX-License-Identifier: MIT
// Names that the engine gives to bones, lines, poses and steps of the history, in words of the person's language.
// What a file or a person has named stays as it is.
import { builtinName, language } from './strings';

/** French nouns and their gender, by the engine's name without its side. */
const BONES: Record<string, [string, 'm' | 'f']> = {
  hips: ['bassin', 'm'],
  spine: ['colonne', 'f'],
  chest: ['thorax', 'm'],
  'upper chest': ['haut du thorax', 'm'],
  neck: ['cou', 'm'],
  head: ['tête', 'f'],
  eye: ['œil', 'm'],
  jaw: ['mâchoire', 'f'],
  trunk: ['tronc', 'm'],
  shoulder: ['épaule', 'f'],
  shoulders: ['épaules', 'f'],
  arm: ['bras', 'm'],
  'upper arm': ['bras', 'm'],
  'lower arm': ['avant-bras', 'm'],
  hand: ['main', 'f'],
  leg: ['jambe', 'f'],
  'upper leg': ['cuisse', 'f'],
  'lower leg': ['jambe', 'f'],
  foot: ['pied', 'm'],
  toes: ['orteils', 'm'],
  thumb: ['pouce', 'm'],
  index: ['index', 'm'],
  middle: ['majeur', 'm'],
  ring: ['annulaire', 'm'],
  little: ['auriculaire', 'm'],
};
const PHALANX: Record<string, number> = { metacarpal: 1, proximal: 1, intermediate: 2, distal: 3 };

const NAMES: Record<string, string> = {
  Relaxed: 'Détendue', Contrapposto: 'Contrapposto', Hero: 'Héros', Walk: 'Marche', Run: 'Course', 'Sprint start': 'Départ',
  Jump: 'Saut', Leap: 'Grand saut', Lunge: 'Fente', 'Reach up': 'Bras levé', Throw: 'Lancer', Bow: 'Révérence',
  'Courtly bow': 'Salut de cour', Sit: 'Assise', 'Sit on floor': 'Assise au sol', Kneel: 'À genoux', Crouch: 'Accroupie',
  Thinking: 'Pensive', 'Arms crossed': 'Bras croisés', Wave: 'Signe', 'Point ahead': 'Montrer', 'On guard': 'En garde',
  Punch: 'Coup de poing', 'High kick': 'Coup de pied', Arabesque: 'Arabesque', 'Hero landing': 'Atterrissage',
  Startled: 'Surprise', Victory: 'Victoire', 'Hand at rest': 'Au repos', Open: 'Ouverte', Fist: 'Poing', Point: 'Index tendu',
  Grip: 'Prise', Pinch: 'Pince', 'Two fingers': 'Deux doigts', 'Thumb up': 'Pouce levé',
  draw: 'tracer', redraw: 'retracer', 'change line': 'changer la ligne', 'hide line': 'masquer la ligne',
  'show line': 'montrer la ligne', 'delete line': 'supprimer la ligne', mirror: 'retourner', reset: 'remettre', rotate: 'tourner',
  move: 'déplacer', pin: 'épingler', unpin: 'désépingler', pose: 'pose', 'keep pose': 'garder la pose', frame: 'image',
  'keep view': 'garder la vue', 'forget view': 'oublier la vue', rules: 'règles', proportions: 'proportions', remove: 'retirer',
  'new table': 'nouvelle table',
};

/** A pose of the shelf, or a step of the history. */
export function named(name: string): string {
  if (language.value !== 'fr') return name;
  const [, verb, object = ''] = /^(add|open) (.+)$/.exec(name) ?? [];
  return verb ? `${verb === 'add' ? 'ajouter' : 'ouvrir'} ${builtinName(object)}` : (NAMES[name] ?? name);
}

/** A bone or a body line: 'left_foot-head' -> 'left foot – head', 'pied gauche – tête'. */
export function spell(name: string): string {
  const words = name.replaceAll('_', ' ').replace(/(?<=[a-z])[A-Z]/g, (capital) => ` ${capital.toLowerCase()}`);
  const ends = words.split(/(?<=\w)-(?=\w)/);
  return (language.value === 'fr' ? ends.map(inFrench) : ends).join(' – ');
}

function inFrench(words: string): string {
  const [, side, bone, phalanx, more] = /^(left |right )?(.+?)(?: (metacarpal|proximal|intermediate|distal))?( \(.*\))?$/.exec(words) ?? [];
  const noun = BONES[bone ?? ''];
  if (!noun) return words;
  const after = side === 'left ' ? ' gauche' : side ? (noun[1] === 'f' ? ' droite' : ' droit') : '';
  const remark = (more ?? '').replace('backward', "à l'envers").replace('depth', 'profondeur');
  return `${noun[0]}${phalanx ? ` ${PHALANX[phalanx]}` : ''}${bone === 'toes' && side ? `${after}s` : after}${remark}`;
}
