// SPDX-License-Identifier: MIT
// One character on the table: its parts as meshes that share one palette.
import * as THREE from 'three';
import type { PartGeometry } from '../engine/messages';
import type { ActorInfo, PartInfo, PoseFrame } from '../engine/protocol';
import { influenceTexture, Palette, skinThroughPalette } from './skin_material';

async function imageTexture(bytes: Uint8Array): Promise<THREE.Texture> {
  const bitmap = await createImageBitmap(new Blob([bytes as BlobPart]), { colorSpaceConversion: 'none' });
  const texture = new THREE.Texture(bitmap);
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.flipY = false;
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  return texture;
}

function bufferGeometry(part: PartGeometry): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(part.positions, 3));
  if (part.normals.length > 0) geometry.setAttribute('normal', new THREE.BufferAttribute(part.normals, 3));
  if (part.uvs.length > 0) geometry.setAttribute('uv', new THREE.BufferAttribute(part.uvs, 2));
  geometry.setIndex(new THREE.BufferAttribute(part.triangles, 1));
  if (part.normals.length === 0) geometry.computeVertexNormals();
  const moving = part.shapes.filter((shape) => shape.weight !== 0 && shape.positions.length > 0);
  if (moving.length > 0) {
    geometry.morphTargetsRelative = true;
    geometry.morphAttributes['position'] = moving.map((shape) => new THREE.BufferAttribute(shape.positions, 3));
  }
  return geometry;
}

function litMaterial(info: PartInfo): THREE.MeshStandardMaterial {
  const [r, g, b, a] = info.base_color;
  const material = new THREE.MeshStandardMaterial({ roughness: 0.82, metalness: 0 });
  material.color.setRGB(r, g, b, THREE.LinearSRGBColorSpace);
  material.side = info.double_sided ? THREE.DoubleSide : THREE.FrontSide;
  if (info.cut_out) material.alphaTest = 0.5;
  else if (a < 1) Object.assign(material, { transparent: true, opacity: a });
  return material;
}

export class CharacterView {
  readonly group = new THREE.Group();
  readonly palette: Palette;
  joints: Float32Array = new Float32Array();

  constructor(readonly info: ActorInfo) {
    this.palette = new Palette(info.palette_size);
  }

  async addPart(index: number, part: PartGeometry): Promise<void> {
    const info = this.info.parts[index]!;
    const influences = influenceTexture(part.joint_indices, part.weights, info.palette_offset);
    const material = litMaterial(info);
    if (part.image) material.map = await imageTexture(part.image).catch(() => null);
    const mesh = new THREE.Mesh(
      bufferGeometry(part),
      skinThroughPalette(material, this.palette, influences, part.influences),
    );
    mesh.morphTargetInfluences = part.shapes.filter((s) => s.weight !== 0 && s.positions.length > 0).map((s) => s.weight);
    mesh.customDepthMaterial = skinThroughPalette(
      new THREE.MeshDepthMaterial({ depthPacking: THREE.RGBADepthPacking }),
      this.palette,
      influences,
      part.influences,
    );
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    mesh.frustumCulled = false; // the bind pose's box says nothing of where the pose is
    this.group.add(mesh);
  }

  show(frame: PoseFrame): void {
    this.palette.set(frame.palette);
    this.joints = frame.joints;
  }

  joint(index: number, into = new THREE.Vector3()): THREE.Vector3 {
    return into.fromArray(this.joints, 3 * index);
  }

  dispose(): void {
    this.group.traverse((object) => {
      if (!(object instanceof THREE.Mesh)) return;
      object.geometry.dispose();
      (object.material as THREE.Material).dispose();
      object.customDepthMaterial?.dispose();
    });
    this.palette.texture.dispose();
  }
}
