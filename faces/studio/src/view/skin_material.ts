// SPDX-License-Identifier: MIT
// three.js skins four influences per vertex; we skin any number, by matrices or by dual quaternions. A vertex finds its
// influences in one texture (palette entry, weight) by its index, and what they do in the character's palette texture:
// one upload per character and frame, however many parts it has.
import * as THREE from 'three';

const WIDTH = 1024; // texels per row of the influence texture
const TEXELS = 5; // per palette entry: three rows of a matrix, the real and the dual part of a dual quaternion

export class Palette {
  readonly texture: THREE.DataTexture;
  private readonly data: Float32Array;
  uploads = 0;

  constructor(entries: number) {
    this.data = new Float32Array(Math.max(1, entries) * TEXELS * 4);
    this.texture = new THREE.DataTexture(this.data, TEXELS, Math.max(1, entries), THREE.RGBAFormat, THREE.FloatType);
    for (let i = 0; i < entries; ++i) this.data.set([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], 4 * TEXELS * i);
    this.texture.needsUpdate = true;
  }

  /** `texels` as the engine gives them. */
  set(texels: Float32Array): void {
    this.data.set(texels.subarray(0, this.data.length));
    this.texture.needsUpdate = true;
    this.uploads += 1;
  }
}

/** What a vertex needs to know beside its position. */
export interface Influences {
  texture: THREE.DataTexture;
  perVertex: number;
}

/** The heaviest influence of each vertex comes first: dual quaternions take their signs from it. A vertex that follows
    nothing follows the part's first entry. */
export function makeInfluences(indices: Uint16Array, weights: Float32Array, perVertex: number, offset: number): Influences {
  const rows = Math.max(1, Math.ceil(weights.length / WIDTH));
  const data = new Float32Array(rows * WIDTH * 2);
  for (let first = 0; first < weights.length; first += perVertex) {
    let heaviest = first;
    for (let i = first; i < first + perVertex; ++i) {
      data[2 * i] = indices[i]! + offset;
      data[2 * i + 1] = weights[i]!;
      if (weights[i]! > weights[heaviest]!) heaviest = i;
    }
    if (weights[heaviest] === 0) {
      data.set([offset, 1], 2 * first);
    } else if (heaviest !== first) {
      data.copyWithin(2 * heaviest, 2 * first, 2 * first + 2);
      data.set([indices[heaviest]! + offset, weights[heaviest]!], 2 * first);
    }
  }
  const texture = new THREE.DataTexture(data, WIDTH, rows, THREE.RGFormat, THREE.FloatType);
  texture.needsUpdate = true;
  return { texture, perVertex };
}

/** croquisBlend() first; then croquisPlace() for positions and croquisTurn() for directions. Where the palette holds no
    dual quaternions their terms are zero, and blending is linear. */
export const SKINNING = /* glsl */ `
  uniform highp sampler2D croquisPalette;
  uniform highp sampler2D croquisInfluences;
  uniform int croquisPerVertex;
  vec4 croquisRow0, croquisRow1, croquisRow2, croquisReal, croquisDual;
  void croquisBlend() {
    croquisRow0 = croquisRow1 = croquisRow2 = croquisReal = croquisDual = vec4(0.0);
    vec4 heaviest = vec4(0.0);
    for (int k = 0; k < croquisPerVertex; ++k) {
      int i = gl_VertexID * croquisPerVertex + k;
      vec2 influence = texelFetch(croquisInfluences, ivec2(i % ${WIDTH}, i / ${WIDTH}), 0).rg;
      float weight = influence.y;
      if (weight == 0.0) continue;
      int entry = int(influence.x + 0.5);
      croquisRow0 += weight * texelFetch(croquisPalette, ivec2(0, entry), 0);
      croquisRow1 += weight * texelFetch(croquisPalette, ivec2(1, entry), 0);
      croquisRow2 += weight * texelFetch(croquisPalette, ivec2(2, entry), 0);
      if (k > 0 && heaviest == vec4(0.0)) continue;
      vec4 real = texelFetch(croquisPalette, ivec2(3, entry), 0);
      if (k == 0) heaviest = real;
      if (dot(heaviest, real) < 0.0) weight = -weight; // q and -q are the same rotation
      croquisReal += weight * real;
      croquisDual += weight * texelFetch(croquisPalette, ivec2(4, entry), 0);
    }
    float square = dot(croquisReal, croquisReal);
    if (square > 0.0) {
      croquisReal *= inversesqrt(square);
      croquisDual *= inversesqrt(square);
    }
  }
  vec3 croquisRotate(vec3 v) {
    return v + 2.0 * cross(croquisReal.xyz, cross(croquisReal.xyz, v) + croquisReal.w * v);
  }
  vec3 croquisTurn(vec3 n) {
    return croquisRotate(vec3(dot(croquisRow0.xyz, n), dot(croquisRow1.xyz, n), dot(croquisRow2.xyz, n)));
  }
  vec3 croquisPlace(vec3 p) {
    vec4 bound = vec4(p, 1.0);
    vec3 stretched = vec3(dot(croquisRow0, bound), dot(croquisRow1, bound), dot(croquisRow2, bound));
    vec3 shift = croquisReal.w * croquisDual.xyz - croquisDual.w * croquisReal.xyz + cross(croquisReal.xyz, croquisDual.xyz);
    return croquisRotate(stretched) + 2.0 * shift;
  }`;

export function skinUniforms(palette: Palette, influences: Influences): Record<string, THREE.IUniform> {
  return {
    croquisPalette: { value: palette.texture },
    croquisInfluences: { value: influences.texture },
    croquisPerVertex: { value: influences.perVertex },
  };
}

/** Teaches a material (the lit one, or the shadow's depth) to skin through the palette. */
export function skinThroughPalette<M extends THREE.Material>(
  material: M,
  palette: Palette,
  influences: Influences,
  alsoTeach: (shader: { fragmentShader: string }) => void = () => {},
): M {
  material.onBeforeCompile = (shader) => {
    alsoTeach(shader);
    Object.assign(shader.uniforms, skinUniforms(palette, influences));
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', `#include <common>\n${SKINNING}`)
      .replace('#include <skinbase_vertex>', 'croquisBlend();')
      .replace('#include <skinnormal_vertex>', 'objectNormal = croquisTurn(objectNormal);')
      .replace('#include <skinning_vertex>', 'transformed = croquisPlace(transformed);');
  };
  material.customProgramCacheKey = () => 'croquis-palette';
  return material;
}
