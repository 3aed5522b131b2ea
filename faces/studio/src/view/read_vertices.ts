// SPDX-License-Identifier: MIT
// Where the graphics card puts the vertices of a part, read back: for comparing with the engine. Blend shapes are left out.
import * as THREE from 'three';
import type { CharacterView } from './character_view';
import { SKINNING, skinUniforms } from './skin_material';

const WIDTH = 512;

export function readVertices(renderer: THREE.WebGLRenderer, view: CharacterView, part: number): Float32Array {
  const { geometry, influences } = view.parts[part]!;
  const position = geometry.getAttribute('position');
  const rows = Math.ceil(position.count / WIDTH);
  const material = new THREE.ShaderMaterial({
    uniforms: skinUniforms(view.palette, influences),
    vertexShader: `${SKINNING}
      varying vec3 placed;
      void main() {
        croquisBlend();
        placed = croquisPlace(position);
        vec2 texel = vec2(gl_VertexID % ${WIDTH}, gl_VertexID / ${WIDTH}) + 0.5;
        gl_Position = vec4(2.0 * texel / vec2(${WIDTH}, ${rows}) - 1.0, 0.0, 1.0);
        gl_PointSize = 1.0;
      }`,
    fragmentShader: 'varying vec3 placed; void main() { gl_FragColor = vec4(placed, 1.0); }',
    depthTest: false,
  });
  const points = new THREE.Points(new THREE.BufferGeometry().setAttribute('position', position), material);
  points.frustumCulled = false;
  const target = new THREE.WebGLRenderTarget(WIDTH, rows, { type: THREE.FloatType, depthBuffer: false });
  renderer.setRenderTarget(target);
  renderer.render(new THREE.Scene().add(points), new THREE.Camera());
  const texels = new Float32Array(WIDTH * rows * 4);
  renderer.readRenderTargetPixels(target, 0, 0, WIDTH, rows, texels);
  renderer.setRenderTarget(null);
  target.dispose();
  material.dispose();
  return Float32Array.from({ length: 3 * position.count }, (_, i) => texels[4 * Math.floor(i / 3) + (i % 3)]!);
}
