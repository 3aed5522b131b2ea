// SPDX-License-Identifier: MIT
// One character on the table: its parts as meshes that share one palette.
import * as THREE from 'three';
import type { PartGeometry } from '../engine/messages';
import type { ActorInfo, PoseFrame } from '../engine/protocol';
import { clayMaterial, lightAsOnPaper } from './clay_material';
import { makeInfluences, Palette, skinThroughPalette, type Influences } from './skin_material';

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

export class CharacterView {
  readonly group = new THREE.Group();
  readonly palette: Palette;
  readonly parts: { geometry: THREE.BufferGeometry; influences: Influences }[] = [];
  joints: Float32Array = new Float32Array();
  texels: Float32Array = new Float32Array();
  private stands: number | null = null;

  constructor(readonly info: ActorInfo) {
    this.palette = new Palette(info.palette_size);
  }

  async addPart(index: number, part: PartGeometry): Promise<void> {
    const info = this.info.parts[index]!;
    const influences = makeInfluences(part.joint_indices, part.weights, part.influences, info.palette_offset);
    const geometry = bufferGeometry(part);
    this.parts[index] = { geometry, influences };
    const material = clayMaterial(info);
    if (part.image) material.map = await imageTexture(part.image).catch(() => null);
    const mesh = new THREE.Mesh(geometry, skinThroughPalette(material, this.palette, influences, lightAsOnPaper));
    mesh.morphTargetInfluences = part.shapes.filter((s) => s.weight !== 0 && s.positions.length > 0).map((s) => s.weight);
    mesh.customDepthMaterial = skinThroughPalette(
      new THREE.MeshDepthMaterial({ side: material.side, alphaTest: material.alphaTest, map: material.map }),
      this.palette,
      influences,
    );
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    mesh.frustumCulled = false; // the bind pose's box says nothing of where the pose is
    this.group.add(mesh);
  }

  show(frame: PoseFrame): void {
    this.palette.set(frame.palette);
    this.texels = frame.palette;
    this.joints = frame.joints;
  }

  /** Joints that are part of the body, in the scene. */
  points(among?: number[]): THREE.Vector3[] {
    const all = among ?? this.info.joints.map((_, i) => i);
    return all.filter((i) => !this.info.joints[i]!.helper && 3 * i < this.joints.length).map((i) => this.joint(i));
  }

  /** The box around the body as it stands: its joints, and about as much flesh as bodies have around them. */
  bounds(among?: number[]): THREE.Box3 {
    const box = new THREE.Box3().setFromPoints(this.points(among));
    if (box.isEmpty()) return box;
    if (among) return box.expandByScalar(0.1 * box.getSize(new THREE.Vector3()).length());
    box.expandByScalar(0.03 * this.info.extent);
    const head = this.info.joints.findIndex((joint) => joint.bone === 'head');
    const skull = new THREE.Box3();
    if (head >= 0) box.union(skull.setFromCenterAndSize(this.joint(head), new THREE.Vector3().setScalar(0.26 * this.info.extent)));
    return box;
  }

  /** Height of the ground under it: zero, if it first stood about there, or lower where its pose reaches lower. */
  floor(): number {
    const lowest = Math.min(...this.points().map((p) => p.y));
    this.stands ??= lowest > 0 && lowest < 0.12 * this.info.extent ? 0 : lowest;
    return Math.min(this.stands, lowest);
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
    for (const { influences } of this.parts) influences.texture.dispose();
    this.palette.texture.dispose();
  }
}
