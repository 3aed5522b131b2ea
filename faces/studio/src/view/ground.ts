// SPDX-License-Identifier: MIT
// The paper that the characters stand on: their shadow, the softer the farther from what casts it, and the dark seam
// where something touches.
import * as THREE from 'three';

const TOUCHES = 16;

const VERTEX = /* glsl */ `
  #include <common>
  #include <shadowmap_pars_vertex>
  varying vec3 croquisAt;
  void main() {
    #include <beginnormal_vertex>
    #include <defaultnormal_vertex>
    #include <begin_vertex>
    #include <project_vertex>
    #include <worldpos_vertex>
    #include <shadowmap_vertex>
    croquisAt = (modelMatrix * vec4(transformed, 1.0)).xyz;
  }`;

const FRAGMENT = /* glsl */ `
  #include <common>
  #include <packing>
  #include <lights_pars_begin>
  #include <shadowmap_pars_fragment>
  uniform vec3 shade;
  uniform float strength;
  uniform vec3 centre;
  uniform float reach;
  uniform vec4 touches[${TOUCHES}]; // x, z, height over the ground, how wide
  varying vec3 croquisAt;

  vec2 spiral(int i, int count, float turn) {
    float r = sqrt((float(i) + 0.5) / float(count));
    float angle = float(i) * 2.39996 + turn;
    return r * vec2(cos(angle), sin(angle));
  }
  float thrown(vec3 s, float turn) {
    #if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
      if (any(lessThan(s.xy, vec2(0.0))) || any(greaterThan(s.xy, vec2(1.0)))) return 0.0;
      float near = 0.0, found = 0.0;
      for (int i = 0; i < 8; ++i) {
        float depth = texture2D(directionalShadowMap[0], s.xy + 0.045 * spiral(i, 8, turn)).r;
        if (depth < s.z) { near += s.z - depth; found += 1.0; }
      }
      if (found == 0.0) return 0.0;
      float soft = clamp(0.22 * near / found, 0.0022, 0.05);
      float sum = 0.0;
      for (int i = 0; i < 16; ++i) {
        sum += step(texture2D(directionalShadowMap[0], s.xy + soft * spiral(i, 16, turn)).r, s.z - 0.0005);
      }
      float fade = 1.0 - 0.55 * smoothstep(0.05, 0.5, near / found);
      return fade * sum / 16.0;
    #else
      return 0.0;
    #endif
  }
  void main() {
    float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    float shadow = 0.0;
    #if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
      shadow = thrown(vDirectionalShadowCoord[0].xyz / vDirectionalShadowCoord[0].w, turn);
    #endif
    float open = 1.0;
    for (int i = 0; i < ${TOUCHES}; ++i) {
      vec2 away = (croquisAt.xz - touches[i].xy) / max(touches[i].w, 1e-6);
      open *= 1.0 - 0.5 * exp(-dot(away, away)) * touches[i].z;
    }
    float dark = 1.0 - (1.0 - 0.62 * shadow) * open;
    float edge = 1.0 - smoothstep(0.6, 1.0, length(croquisAt.xz - centre.xz) / reach);
    gl_FragColor = vec4(shade, strength * dark * edge);
    #include <colorspace_fragment>
  }`;

export class Ground {
  readonly mesh: THREE.Mesh<THREE.CircleGeometry, THREE.ShaderMaterial>;

  constructor() {
    const own = {
      shade: { value: new THREE.Color() },
      strength: { value: 0.4 },
      centre: { value: new THREE.Vector3() },
      reach: { value: 1 },
      touches: { value: Array.from({ length: TOUCHES }, () => new THREE.Vector4()) },
    };
    const uniforms = Object.assign(THREE.UniformsUtils.merge([THREE.UniformsLib['lights']]), own);
    const material = new THREE.ShaderMaterial({ uniforms, vertexShader: VERTEX, fragmentShader: FRAGMENT, lights: true, transparent: true, depthWrite: false });
    this.mesh = new THREE.Mesh(new THREE.CircleGeometry(1, 48), material);
    this.mesh.rotation.x = -Math.PI / 2;
    this.mesh.receiveShadow = true;
    this.mesh.renderOrder = -1;
  }

  setShade(color: string, strength: number): void {
    const { uniforms } = this.mesh.material;
    (uniforms['shade']!.value as THREE.Color).set(color);
    uniforms['strength']!.value = strength;
  }

  place(centre: THREE.Vector3, height: number, reach: number): void {
    this.mesh.position.set(centre.x, height, centre.z);
    this.mesh.scale.setScalar(reach);
    const { uniforms } = this.mesh.material;
    (uniforms['centre']!.value as THREE.Vector3).copy(centre);
    uniforms['reach']!.value = reach;
  }

  /** The seam under what is nearest to the ground. `width` is how far a touch darkens the paper. */
  setTouches(points: THREE.Vector3[], width: number): void {
    const height = (p: THREE.Vector3) => Math.max(0, p.y - this.mesh.position.y);
    const lowest = [...points].sort((a, b) => a.y - b.y).slice(0, TOUCHES);
    const touches = this.mesh.material.uniforms['touches']!.value as THREE.Vector4[];
    touches.forEach((touch, i) => {
      const p = lowest[i];
      if (p) touch.set(p.x, p.z, Math.exp((-1.2 * height(p)) / width), width + 0.5 * height(p));
      else touch.set(0, 0, 0, 1);
    });
  }
}
