// SPDX-License-Identifier: MIT
// Pictures to take away and to choose from: the table as a PNG, the OpenPose figure, thumbnails of poses.
import type { Command } from './engine/protocol';
import { dark } from './model/prefs';
import type { Table } from './model/table';
import type { Overlay } from './overlay';
import { InkLayer } from './view/ink';
import { drawOpenPose } from './view/open_pose_picture';
import type { Stage } from './view/stage';

export interface PictureOptions {
  width: number;
  height: number;
  transparent: boolean;
  strokes: boolean;
  /** The picture that is traced, as faint as it is on the table. */
  backdrop: boolean;
}

export interface Backdrop {
  url: string;
  opacity: number;
}

const toBlob = (canvas: HTMLCanvasElement): Promise<Blob | null> => new Promise((resolve) => canvas.toBlob(resolve, 'image/png'));

export class Pictures {
  constructor(
    private readonly table: Table,
    private readonly stage: Stage,
    private readonly overlay: Overlay,
    private readonly backdrop: () => Backdrop | null,
  ) {}

  /** What is on the table, as high as the table is; where the picture is narrower its sides are cut off. */
  async png(options: PictureOptions): Promise<Blob | null> {
    const { width, height, transparent, strokes } = options;
    const traced = options.backdrop ? await loaded(this.backdrop()) : null;
    const sheet = { width: this.stage.canvas.clientWidth, height: this.stage.canvas.clientHeight };
    const scale = height / sheet.height;
    const left = (width - sheet.width * scale) / 2;
    const canvas = document.createElement('canvas');
    Object.assign(canvas, { width, height });
    const context = canvas.getContext('2d')!;
    if (!transparent) {
      context.fillStyle = dark.value ? '#24211e' : '#f7f2e8';
      context.fillRect(0, 0, width, height);
    }
    if (traced) {
      const { image, opacity } = traced;
      const contain = scale * Math.min(sheet.width / image.naturalWidth, sheet.height / image.naturalHeight);
      const size = { width: image.naturalWidth * contain, height: image.naturalHeight * contain };
      context.globalAlpha = opacity;
      context.drawImage(image, (width - size.width) / 2, (height - size.height) / 2, size.width, size.height);
      context.globalAlpha = 1;
    }
    this.stage.drawOnto(canvas, transparent);
    if (strokes) {
      const ink = new InkLayer(document.createElement('canvas'));
      ink.resize(sheet.width, sheet.height, scale);
      this.overlay.draw(null, null, { helpers: false, ink });
      context.drawImage(ink.canvas, left, 0);
    }
    return toBlob(canvas);
  }

  /** The figure of everyone on the table, on black, as picture-making programs want it. */
  async openPose(): Promise<Blob | null> {
    const json = await this.table.engine.export('openpose', this.table.actor.value, { camera: this.stage.rig.toSpec() });
    return toBlob(drawOpenPose(new TextDecoder().decode(json)));
  }

  /** Small pictures of poses, as they look on the current character; empty where it cannot take one. */
  async thumbnails(poses: { pose: string; hand: boolean }[]): Promise<string[]> {
    const actor = this.table.actor.value;
    const view = this.stage.characters.get(actor);
    if (!view) return [];
    const commands = poses.map(({ pose }): Command => ({ name: 'apply_pose', actor, pose, strength: 1, flipped: false }));
    const frames = await this.table.engine.poseFrames(commands);
    const hand = view.info.joints.flatMap((joint, i) => (/^left(Hand|Thumb|Index|Middle|Ring|Little)/.test(joint.bone) ? [i] : []));
    const wanted = frames.flatMap((frame, i) => (frame ? [{ frame, focus: poses[i]!.hand ? hand : [], i }] : []));
    const pictures = this.stage.thumbnails(actor, wanted, 144);
    const urls = poses.map(() => '');
    wanted.forEach(({ i }, k) => (urls[i] = pictures[k]?.toDataURL('image/png') ?? ''));
    return urls;
  }
}

async function loaded(backdrop: Backdrop | null): Promise<{ image: HTMLImageElement; opacity: number } | null> {
  if (!backdrop) return null;
  const image = new Image();
  image.src = backdrop.url;
  await image.decode();
  return { image, opacity: backdrop.opacity };
}
