// SPDX-License-Identifier: MIT
/** A GLB of a standing tube with `count` vertices, skinned smoothly to a chain of six joints. */
export function bigGlb(count) {
  const joints = 6;
  const around = 100;
  const rings = Math.ceil(count / around);
  const positions = new Float32Array(rings * around * 3);
  const indices = new Uint8Array(rings * around * 4);
  const weights = new Float32Array(rings * around * 4);
  const triangles = new Uint32Array((rings - 1) * around * 6);
  for (let r = 0; r < rings; ++r) {
    const height = r / (rings - 1);
    const along = height * (joints - 1);
    const lower = Math.min(joints - 2, Math.floor(along));
    for (let a = 0; a < around; ++a) {
      const v = r * around + a;
      const angle = (2 * Math.PI * a) / around;
      positions.set([0.12 * Math.cos(angle), 1.5 * height, 0.12 * Math.sin(angle)], 3 * v);
      indices.set([lower, lower + 1, 0, 0], 4 * v);
      weights.set([1 - (along - lower), along - lower, 0, 0], 4 * v);
      if (r + 1 === rings) continue;
      const [right, up] = [r * around + ((a + 1) % around), v + around];
      triangles.set([v, up, right, right, up, right + around], 6 * v);
    }
  }
  const inverse = new Float32Array(joints * 16);
  for (let j = 0; j < joints; ++j) inverse.set([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -(1.5 * j) / (joints - 1), 0, 1], 16 * j);
  const parts = [positions, indices, weights, triangles, inverse];
  const views = [];
  let length = 0;
  for (const part of parts) {
    views.push({ buffer: 0, byteOffset: length, byteLength: part.byteLength });
    length += part.byteLength;
  }
  const vertices = rings * around;
  const json = {
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0, joints] }],
    nodes: [
      ...Array.from({ length: joints }, (_, j) => ({ name: `bone${j}`, ...(j + 1 < joints ? { children: [j + 1] } : {}), translation: [0, j ? 1.5 / (joints - 1) : 0, 0] })),
      { name: 'tube', mesh: 0, skin: 0 },
    ],
    skins: [{ joints: Array.from({ length: joints }, (_, j) => j), inverseBindMatrices: 4 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, JOINTS_0: 1, WEIGHTS_0: 2 }, indices: 3 }] }],
    buffers: [{ byteLength: length }], bufferViews: views,
    accessors: [
      { bufferView: 0, componentType: 5126, count: vertices, type: 'VEC3', min: [-0.12, 0, -0.12], max: [0.12, 1.5, 0.12] },
      { bufferView: 1, componentType: 5121, count: vertices, type: 'VEC4' },
      { bufferView: 2, componentType: 5126, count: vertices, type: 'VEC4' },
      { bufferView: 3, componentType: 5125, count: triangles.length, type: 'SCALAR' },
      { bufferView: 4, componentType: 5126, count: joints, type: 'MAT4' },
    ],
  };
  const text = Buffer.from(JSON.stringify(json));
  const head = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, 32)]);
  const body = Buffer.concat(parts.map((part) => Buffer.from(part.buffer)));
  const chunk = (type, bytes) => {
    const start = Buffer.alloc(8);
    start.writeUInt32LE(bytes.length, 0);
    start.write(type, 4, 'latin1');
    return Buffer.concat([start, bytes]);
  };
  const chunks = Buffer.concat([chunk('JSON', head), chunk('BIN\0', body)]);
  const start = Buffer.alloc(12);
  start.write('glTF', 0, 'latin1');
  start.writeUInt32LE(2, 4);
  start.writeUInt32LE(12 + chunks.length, 8);
  return Buffer.concat([start, chunks]);
}
