// SPDX-License-Identifier: MIT
// The studio without its panels: table, stage, ink and tools put together. Panels and keys call its methods.
import { effect, signal } from '@preact/signals';
import * as THREE from 'three';
import type { EngineClient } from './engine/client';
import type { ActorInfo, CameraSpec, Command, ExportFormat, PoseFrame, Sample, StrokeInfo, Vec3 } from './engine/protocol';
import { t } from './i18n/strings';
import type { Journal } from './model/journal';
import { keepAll } from './model/pose_shelf';
import { dark, dualQuaternions, leftHanded, showSkeleton } from './model/prefs';
import { Table } from './model/table';
import { isEnd, isInView, type LiveLine, newestStroke, Overlay } from './overlay';
import { DragTool, RotateTool, SelectTool, type BodyContext } from './tools/body_tools';
import { distanceTo, DrawTool, type DrawContext } from './tools/draw_tool';
import { Gestures } from './tools/gestures';
import { AXES, type Axis, type Tool, type ToolName } from './tools/tool';
import { Pictures, type Backdrop } from './pictures';
import { InkLayer } from './view/ink';
import { Stage, type Quality } from './view/stage';

const REACH_PX = 36; // a finger's reach around a joint
const STEEP = 0.02; // as the engine has it: seen from so near to the vertical an upright plane is a line
const IDLE_MS = 2500; // without a change, before the project is kept beside the journal

export class Studio {
  readonly table: Table;
  readonly stage: Stage;
  readonly ink: InkLayer;
  readonly gestures: Gestures;
  readonly tool = signal<ToolName>('draw');
  readonly axis = signal<Axis | null>(null);
  readonly drawingNow = signal(false);
  readonly backdrop = signal<Backdrop | null>(null);
  readonly light = signal({ heading: -0.42, elevation: 0.91 });
  private readonly tools: Record<ToolName, Tool>;
  private live: LiveLine | null = null;
  readonly pictures: Pictures;
  private readonly overlay: Overlay;
  private hovered: number | null = null;
  private copied: { pose: string } | null = null;
  private size = { width: 1, height: 1 };
  private panelsOpen = false;
  private keeping: ReturnType<typeof setTimeout> | undefined;

  constructor(engine: EngineClient, journal: Journal, canvas: HTMLCanvasElement, glass: HTMLCanvasElement, quality: Quality = 'full') {
    this.table = new Table(engine, journal);
    this.stage = new Stage(canvas, quality);
    this.ink = new InkLayer(glass);
    this.overlay = new Overlay(this.table, this.stage, this.ink, () => this.tool.value, () => this.axis.value);
    this.pictures = new Pictures(this.table, this.stage, this.overlay, () => this.backdrop.value);
    const body = this.bodyContext();
    const rotate = new RotateTool(body);
    this.tools = {
      draw: new DrawTool(this.drawContext()),
      drag: new DragTool(body),
      rotate,
      select: new SelectTool(body),
    };
    this.gestures = new Gestures({
      toolDown: (p) => this.active.down(p),
      toolMove: (ps) => this.active.move(ps),
      toolUp: (p) => this.active.up(p),
      toolCancel: () => this.active.cancel(),
      hover: (p) => this.active.hover?.(p),
      orbit: (dx, dy) => this.stage.rig.orbit(dx, dy),
      pan: (dx, dy) => this.stage.rig.pan(dx, dy),
      zoom: (factor) => this.stage.rig.zoom(factor),
      undo: () => void this.table.undo(),
      redo: () => void this.table.redo(),
    });
    this.table.onState = () => this.follow();
    this.table.onFrames = (frames) => this.showFrames(frames);
    this.stage.onDrawn = () => this.drawInk();
    effect(() => {
      this.stage.setTheme(dark.value ? { paper: '#24211e', shade: '#0b0908', strength: 0.75 } : { paper: '#f7f2e8', shade: '#3a3026', strength: 0.5 });
    });
    effect(() => this.stage.setLight(this.light.value.heading, this.light.value.elevation));
    effect(() => {
      void [showSkeleton.value, this.tool.value, this.table.stroke.value, this.table.joint.value, this.table.picked.value, this.table.segments.value, this.table.drawing.value];
      this.stage.invalidate();
    });
    effect(() => {
      void this.axis.value;
      rotate.turned();
      this.stage.invalidate();
    });
    effect(() => void this.table.skinBy(dualQuaternions.value));
    this.stage.setPlane(() => this.uprightPlane()?.normal ?? null);
    effect(() => void this.table.checkPicked(this.table.picked.value, this.table.actor.value));
  }

  get active(): Tool {
    return this.tools[this.tool.value];
  }

  /** Fetches what an earlier visit left, or sets out the mannequin. */
  async start(): Promise<void> {
    const found = await this.table.replay();
    if (!found || this.table.state.value.actors.length === 0) await this.table.run({ name: 'add_character', character: 'mannequin' });
    this.frameSelected();
    effect(() => {
      void this.table.state.value;
      clearTimeout(this.keeping);
      this.keeping = setTimeout(() => this.keepWhenIdle(), IDLE_MS);
    });
  }

  private keepWhenIdle(): void {
    if (this.gestures.path === 'idle') void this.table.keepCheckpoint().catch(() => {});
    else this.keeping = setTimeout(() => this.keepWhenIdle(), IDLE_MS);
  }

  resize(width: number, height: number): void {
    this.size = { width, height };
    const ratio = Math.min(2, devicePixelRatio || 1);
    this.stage.resize(width, height, ratio);
    this.ink.resize(width, height, ratio);
    this.inset();
  }

  /** Whether the panels are open; on wide screens they stand beside the character, on others over it. */
  setPanels(open: boolean): void {
    this.panelsOpen = open;
    this.inset();
  }

  /** What tools and panels cover, so that characters are framed beside them. */
  private inset(): void {
    const [tools, panels] = [84, this.panelsOpen && this.size.width >= 900 ? 308 : 20];
    const [left, right] = leftHanded.value ? [panels, tools] : [tools, panels];
    const otherHand = (left - right) * (this.stage.insets.left - this.stage.insets.right) < 0;
    this.stage.insets = { left, right, top: 76, bottom: 100 };
    if (otherHand && this.panelsOpen) this.frameSelected(); // the panels are now where it stood
    document.documentElement.style.setProperty('--left', `${left}px`);
    document.documentElement.style.setProperty('--right', `${right}px`);
  }

  choose(tool: ToolName): void {
    this.gestures.cancel();
    this.tool.value = tool;
    this.axis.value = null;
  }

  /** Holds rotations to an axis; the same one again lets go. */
  holdAxis(axis: Axis): void {
    this.axis.value = this.axis.value === axis ? null : axis;
  }

  /** A step through the readings of the newest line: other body line, other direction, other depth. */
  async cycle(step: number): Promise<void> {
    const stroke = this.strokeInHand();
    if (!stroke) return;
    const solved = this.table.solvedStroke.value === stroke.id ? this.table.solved.value : null;
    const count = solved?.alternatives.length ?? 6;
    if (count > 1) await this.chooseAlternative(((solved?.chosen ?? stroke.settings.alternative) + step + count) % count);
  }

  async chooseAlternative(alternative: number): Promise<void> {
    const stroke = this.strokeInHand();
    if (stroke) await this.table.run({ name: 'set_stroke', stroke: stroke.id, settings: { alternative } });
  }

  strokeInHand(): StrokeInfo | null {
    return newestStroke(this.table);
  }

  async addCharacter(name: string): Promise<void> {
    await this.table.run({ name: 'add_character', character: name });
    this.table.take(this.table.state.value.actors.at(-1)?.id ?? 0);
    this.frameSelected();
  }

  async newTable(): Promise<void> {
    await this.table.run({ name: 'clear' });
    await this.addCharacter('mannequin');
  }

  /** Puts a file on the table: a character, a project, kept poses, or a picture to trace. */
  async openFile(file: File): Promise<boolean> {
    if (file.type.startsWith('image/')) {
      this.backdrop.value = { url: URL.createObjectURL(file), opacity: 0.5 };
      return true;
    }
    if (file.name.endsWith('.json')) return this.openPoses(file);
    const bytes = new Uint8Array(await file.arrayBuffer());
    const change = await this.table.run({ name: 'open', file: file.name }, bytes);
    if (!change) return false;
    const newest = this.table.state.value.actors.at(-1);
    if (newest) this.table.take(newest.id);
    this.frameSelected();
    this.table.tell(t('opened', newest?.name || file.name));
    return true;
  }

  private async openPoses(file: File): Promise<boolean> {
    try {
      const count = keepAll(await file.text());
      this.table.tell(t('posesOpened', count));
      return true;
    } catch (error) {
      this.table.tell(t('posesRefused', file.name, (error as Error).message), 'error');
      return false;
    }
  }

  async export(format: ExportFormat): Promise<Blob | null> {
    try {
      const bytes = await this.table.engine.export(format, this.table.actor.value, { camera: this.stage.rig.toSpec() });
      return new Blob([bytes as BlobPart]);
    } catch (error) {
      this.table.tell((error as Error).message, 'error');
      return null;
    }
  }

  frameSelected(): void {
    this.stage.frame(this.table.current.value?.id);
  }

  /** A view after the current character's own front. */
  look(view: 'front' | 'side' | 'top' | 'back' | 'threeQuarter', opposite = false): void {
    const front = this.table.current.value?.front ?? [0, 0, 1];
    const heading = Math.atan2(front[0], front[2]);
    const turns = { front: 0, side: Math.PI / 2, top: 0, back: Math.PI, threeQuarter: Math.PI / 5 };
    const elevation = view === 'top' ? (opposite ? -1 : 1) * (Math.PI / 2) : view === 'threeQuarter' ? 0.25 : 0;
    this.stage.rig.set({ heading: heading + turns[view] + (opposite && view !== 'top' ? Math.PI : 0), elevation });
  }

  /** The limb that a joint belongs to: it and everything that hangs on it. */
  limbOf(joint: number): number[] {
    const joints = this.table.current.value?.joints ?? [];
    return joints.flatMap((_, i) => {
      for (let at = i; at >= 0; at = joints[at]!.parent) if (at === joint) return [i];
      return [];
    });
  }

  async copyPose(): Promise<void> {
    this.copied = await this.table.engine.query<{ pose: string }>('pose', { actor: this.table.actor.value });
  }

  async pastePose(flipped: boolean): Promise<void> {
    if (!this.copied) return this.table.tell(t('nothingCopied'));
    await this.table.run({ name: 'apply_pose', actor: this.table.actor.value, pose: this.copied.pose, strength: 1, flipped });
  }

  private drawContext(): DrawContext {
    return {
      editable: () => {
        const stroke = this.table.currentStroke.value;
        return stroke && !stroke.hidden && isInView(stroke, this.stage.rig) ? stroke : null;
      },
      camera: () => this.stage.rig.toSpec(),
      refuses: () => this.refusesPlane(),
      aim: (x, y) => void this.takeActorAt(x, y, 2 * REACH_PX),
      drawCommand: (samples, camera) => this.drawCommand(samples, camera),
      preview: (command) => this.table.preview(command),
      commit: (command) => void this.commitLine(command),
      cancelPreview: () => void this.table.endPreview(),
      showInk: (samples, editing) => {
        this.live = samples ? { samples, editing } : null;
        this.drawingNow.value = samples !== null;
        this.drawInk();
      },
    };
  }

  private async commitLine(command: Command): Promise<void> {
    const change = await this.table.run(command);
    if (change?.state && command.name === 'draw') this.table.stroke.value = change.state.strokes.at(-1)?.id ?? null;
  }

  private drawCommand(samples: Sample[], camera: CameraSpec): Command {
    const picked = this.table.picked.value;
    const settings = { ...this.table.drawing.value, ...(picked.length > 1 ? { joints: picked, body_line: '' } : {}) };
    return { name: 'draw', actor: this.table.actor.value, samples, camera, settings };
  }

  private bodyContext(): BodyContext {
    const view = () => this.stage.characters.get(this.table.actor.value);
    return {
      actor: () => this.table.actor.value,
      jointAt: (x, y, endsOnly) => this.jointAt(x, y, endsOnly),
      takeActorAt: (x, y) => this.takeActorAt(x, y, REACH_PX),
      strokeAt: (x, y) => this.strokeAt(x, y),
      jointPixel: (joint) => this.stage.rig.project(view()?.joint(joint) ?? new THREE.Vector3()),
      planeThrough: (joint) => {
        const through = view()?.joint(joint) ?? new THREE.Vector3();
        return (x, y) => this.stage.rig.unproject(x, y, through).toArray() as Vec3;
      },
      viewAxis: () => this.stage.rig.camera.getWorldDirection(new THREE.Vector3()).negate().toArray() as Vec3,
      heldAxis: () => (this.axis.value ? AXES[this.axis.value] : null),
      axisInView: (axis) => {
        const { x, y, z } = new THREE.Vector3(...axis).transformDirection(this.stage.rig.camera.matrixWorldInverse);
        return { x, y, toward: z };
      },
      boneAxis: (joint) => {
        const character = view();
        const child = character?.info.joints.findIndex((j) => j.parent === joint) ?? -1;
        if (!character || child < 0) return [0, 1, 0];
        return character.joint(child).sub(character.joint(joint)).normalize().toArray() as Vec3;
      },
      selectJoint: (joint) => (this.table.joint.value = joint),
      selectStroke: (stroke) => this.table.takeStroke(stroke),
      togglePicked: (joint) => {
        const picked = this.table.picked.value;
        this.table.picked.value = picked.includes(joint) ? picked.filter((j) => j !== joint) : [...picked, joint];
      },
      hoverJoint: (joint) => {
        if (joint === this.hovered) return;
        this.hovered = joint;
        this.drawInk();
      },
      preview: (command) => this.table.preview(command),
      commit: (command) => void this.table.run(command),
      cancelPreview: () => void this.table.endPreview(),
    };
  }

  private jointAt(x: number, y: number, endsOnly: boolean): number | null {
    return this.nearestJoint(this.table.actor.value, x, y, endsOnly).joint;
  }

  private nearestJoint(actor: number, x: number, y: number, endsOnly = false, within = REACH_PX): { joint: number | null; distance: number } {
    const best = { joint: null as number | null, distance: within };
    const view = this.stage.characters.get(actor);
    view?.info.joints.forEach((joint, i) => {
      if (joint.helper || (endsOnly && !isEnd(view.info, i))) return;
      const at = this.stage.rig.project(view.joint(i));
      const distance = Math.hypot(at.x - x, at.y - y);
      if (distance < best.distance) Object.assign(best, { joint: i, distance });
    });
    return best;
  }

  /** Another character, if it has a joint there and the one in hand has none within `clear` pixels. */
  private takeActorAt(x: number, y: number, clear: number): boolean {
    const inHand = this.table.actor.value;
    if (this.nearestJoint(inHand, x, y, false, clear).joint !== null) return false;
    const others = [...this.stage.characters.keys()].filter((id) => id !== inHand);
    const [nearest] = others.map((id) => ({ id, ...this.nearestJoint(id, x, y) })).sort((a, b) => a.distance - b.distance);
    if (!nearest || nearest.joint === null) return false;
    this.table.take(nearest.id);
    return true;
  }

  private strokeAt(x: number, y: number): number | null {
    const near = this.table.state.value.strokes.filter(
      (stroke) => !stroke.hidden && isInView(stroke, this.stage.rig) && distanceTo(stroke.samples, { x, y }).distance < 14,
    );
    return near.at(-1)?.id ?? null;
  }

  /** Brings the characters of the stage in line with the table's. */
  private async follow(): Promise<void> {
    const now = (id: number) => this.table.state.value.actors.find((actor) => actor.id === id);
    for (const [id, view] of [...this.stage.characters]) if (!isSameBody(now(id), view.info)) this.stage.removeCharacter(id);
    for (const actor of this.table.state.value.actors) {
      if (this.stage.characters.has(actor.id)) continue;
      try {
        await this.stage.addCharacter(actor, (part) => this.table.engine.geometry(actor.id, part));
      } catch (error) {
        if (now(actor.id)) throw error; // otherwise it was taken away while its buffers came
        continue;
      }
      this.showFrames((await this.table.engine.cancelPreview()).frames);
    }
    this.stage.invalidate();
  }

  private showFrames(frames: PoseFrame[]): void {
    this.stage.show(frames);
  }

  /** The upright plane that lines are meant to lie in, for the methods that use it: its normal; null where it would be
      seen from straight above. */
  private uprightPlane(): { normal: THREE.Vector3 | null } | null {
    const { plane, method } = this.table.drawing.value;
    if (plane !== 'ground' || method === 'line') return null;
    const away = this.stage.rig.camera.getWorldDirection(new THREE.Vector3()).setY(0);
    return { normal: away.length() < STEEP ? null : away.normalize() };
  }

  private refusesPlane(): boolean {
    const refused = this.uprightPlane()?.normal === null;
    if (refused) this.table.tell(t('planeRefused'), 'error');
    return refused;
  }

  private drawInk(): void {
    this.overlay.draw(this.live, this.hovered);
  }
}

function isSameBody(a: ActorInfo | undefined, b: ActorInfo): boolean {
  return a !== undefined && a.palette_size === b.palette_size && JSON.stringify(a.proportions) === JSON.stringify(b.proportions);
}
