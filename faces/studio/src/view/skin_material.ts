// SPDX-License-Identifier: MIT
// three.js skins four influences per vertex; we skin any number. A vertex finds its influences in one texture (palette
// entry, weight) by its index, and the matrices in the character's palette texture: one upload per character and frame,
// however many parts it has.
import * as THREE from 'three';

const WIDTH = 1024; // texels per row of the influence texture

/** Three texels per palette entry: the rows of the 3x4 matrix. */
export class Palette {
  readonly texture: THREE.DataTexture;
  private readonly data: Float32Array;
  uploads = 0;

  constructor(readonly entries: number) {
    this.data = new Float32Array(Math.max(1, entries) * 12);
    this.texture = new THREE.DataTexture(this.data, 3, Math.max(1, entries), THREE.RGBAFormat, THREE.FloatType);
    for (let i = 0; i < entries; ++i) this.data.set([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], 12 * i);
    this.texture.needsUpdate = true;
  }

  /** `matrices`: 16 numbers per entry, column-major, as the engine gives them. */
  set(matrices: Float32Array): void {
    for (let entry = 0; entry < this.entries; ++entry) {
      for (let row = 0; row < 3; ++row) {
        for (let column = 0; column < 4; ++column) {
          this.data[12 * entry + 4 * row + column] = matrices[16 * entry + 4 * column + row]!;
        }
      }
    }
    this.texture.needsUpdate = true;
    this.uploads += 1;
  }
}

export function influenceTexture(indices: Uint16Array, weights: Float32Array, offset: number): THREE.DataTexture {
  const rows = Math.max(1, Math.ceil(weights.length / WIDTH));
  const data = new Float32Array(rows * WIDTH * 2);
  for (let i = 0; i < weights.length; ++i) {
    data[2 * i] = indices[i]! + offset;
    data[2 * i + 1] = weights[i]!;
  }
  const texture = new THREE.DataTexture(data, WIDTH, rows, THREE.RGFormat, THREE.FloatType);
  texture.needsUpdate = true;
  return texture;
}

const DECLARATIONS = /* glsl */ `
  uniform highp sampler2D croquisPalette;
  uniform highp sampler2D croquisInfluences;
  uniform int croquisPerVertex;
  void croquisBlend(out vec4 r0, out vec4 r1, out vec4 r2) {
    r0 = r1 = r2 = vec4(0.0);
    float total = 0.0;
    for (int k = 0; k < croquisPerVertex; ++k) {
      int i = gl_VertexID * croquisPerVertex + k;
      vec2 influence = texelFetch(croquisInfluences, ivec2(i % ${WIDTH}, i / ${WIDTH}), 0).rg;
      if (influence.y == 0.0 && k > 0) continue;
      float weight = influence.y;
      int entry = int(influence.x + 0.5);
      r0 += weight * texelFetch(croquisPalette, ivec2(0, entry), 0);
      r1 += weight * texelFetch(croquisPalette, ivec2(1, entry), 0);
      r2 += weight * texelFetch(croquisPalette, ivec2(2, entry), 0);
      total += weight;
    }
    if (total == 0.0) { // a vertex without weights follows the first entry
      int entry = int(texelFetch(croquisInfluences, ivec2(0, 0), 0).r + 0.5);
      r0 = texelFetch(croquisPalette, ivec2(0, entry), 0);
      r1 = texelFetch(croquisPalette, ivec2(1, entry), 0);
      r2 = texelFetch(croquisPalette, ivec2(2, entry), 0);
    }
  }`;

/** Teaches a material (the lit one, or the shadow's depth) to skin through the palette. */
export function skinThroughPalette<M extends THREE.Material>(
  material: M,
  palette: Palette,
  influences: THREE.DataTexture,
  perVertex: number,
  alsoTeach: (shader: { fragmentShader: string }) => void = () => {},
): M {
  material.onBeforeCompile = (shader) => {
    alsoTeach(shader);
    shader.uniforms['croquisPalette'] = { value: palette.texture };
    shader.uniforms['croquisInfluences'] = { value: influences };
    shader.uniforms['croquisPerVertex'] = { value: perVertex };
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', `#include <common>\n${DECLARATIONS}`)
      .replace(
        '#include <skinnormal_vertex>',
        `vec4 n0, n1, n2;
         croquisBlend(n0, n1, n2);
         objectNormal = vec3(dot(n0.xyz, objectNormal), dot(n1.xyz, objectNormal), dot(n2.xyz, objectNormal));`,
      )
      .replace(
        '#include <skinning_vertex>',
        `vec4 r0, r1, r2;
         croquisBlend(r0, r1, r2);
         vec4 bound = vec4(transformed, 1.0);
         transformed = vec3(dot(r0, bound), dot(r1, bound), dot(r2, bound));`,
      );
  };
  material.customProgramCacheKey = () => 'croquis-palette';
  return material;
}
