// SPDX-License-Identifier: MIT
import { afterEach, describe, expect, it } from 'vitest';
import { named, spell } from '../src/i18n/names';
import { language } from '../src/i18n/strings';
import { startLocalEngine } from './local_engine';

afterEach(() => {
  language.value = 'en';
});

describe('names in words', () => {
  it('are spelled in English', () => {
    expect(spell('left_foot-head')).toBe('left foot – head');
    expect(spell('leftUpperArm')).toBe('left upper arm');
    expect(spell('shoulders (backward)')).toBe('shoulders (backward)');
  });

  it('are said in French, each noun with its gender', () => {
    language.value = 'fr';
    expect(spell('left_foot-head')).toBe('pied gauche – tête');
    expect(spell('rightHand')).toBe('main droite');
    expect(spell('leftToes')).toBe('orteils gauches');
    expect(spell('rightIndexIntermediate')).toBe('index 2 droit');
    expect(spell('hips-left_hand (depth 2)')).toBe('bassin – main gauche (profondeur 2)');
    expect(named('add cat')).toBe('ajouter chat');
    expect(named('mirror')).toBe('retourner');
    expect(spell('tail_8'), 'what has no translation stays').toBe('tail 8');
  });

  it('every bone, line and pose of the mannequin has a French one', async () => {
    const engine = await startLocalEngine();
    const { state } = await engine.commit({ name: 'add_character', character: 'mannequin' });
    const { poses } = await engine.query<{ poses: { name: string }[] }>('shelf', { actor: state!.actors[0]!.id });
    const said = (): string[] => [
      ...state!.actors[0]!.joints.map((joint) => spell(joint.bone)),
      ...state!.actors[0]!.body_lines.map((line) => spell(line.name)),
      ...poses.map((pose) => named(pose.name)),
    ];
    const english = said();
    language.value = 'fr';
    const same = said().filter((name, i) => name === english[i]);
    expect(same).toEqual(['Contrapposto', 'Arabesque']);
  });
});
