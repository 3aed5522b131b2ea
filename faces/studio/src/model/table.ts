// SPDX-License-Identifier: MIT
// The page's mirror of the engine's project, as signals. Nothing here decides: every change is a command that goes to
// the engine, and what comes back is shown and journalled.
import { batch, computed, signal } from '@preact/signals';
import type { Change } from '../engine/messages';
import type { EngineClient, EngineError } from '../engine/client';
import type { Command, PoseFrame, Solved, StrokeSettings, TableState } from '../engine/protocol';
import { t } from '../i18n/strings';
import { stepsStayAbove, type Checkpoint, type Entry, type Journal } from './journal';

const CHECKPOINT_AFTER = 12; // entries

export const EMPTY_STATE: TableState = {
  actors: [],
  strokes: [],
  settings: { limits: 'anatomical', floor: true, balance: false, root: 'free' },
  views: [],
  poses: [],
  undo: '',
  redo: '',
};

export interface Toast {
  id: number;
  text: string;
  kind: 'note' | 'error';
}

export interface Timing {
  solve_ms: number;
  engine_ms: number;
  transfer_ms: number;
}

export class Table {
  readonly state = signal<TableState>(EMPTY_STATE);
  readonly solved = signal<Solved | null>(null);
  readonly actor = signal(0);
  readonly stroke = signal<number | null>(null);
  readonly joint = signal<number | null>(null);
  /** Joints picked by hand for the next line, in order. */
  readonly picked = signal<number[]>([]);
  /** The segments that they make, and why they do not where they do not. */
  readonly segments = signal<number[][]>([]);
  readonly pickedFault = signal('');
  /** The line that `solved` is about. */
  readonly solvedStroke = signal<number | null>(null);
  readonly drawing = signal<Partial<StrokeSettings>>({ method: 'line', body_line: 'auto' });
  readonly toasts = signal<Toast[]>([]);
  /** Changes that are on their way: the page shows what the engine holds when there is none. */
  readonly busy = signal(0);
  /** There are steps before those that the engine holds. */
  readonly earlier = signal(false);
  readonly timings: Timing[] = [];
  readonly current = computed(() => this.state.value.actors.find((a) => a.id === this.actor.value) ?? null);
  readonly currentStroke = computed(() => this.state.value.strokes.find((s) => s.id === this.stroke.value) ?? null);

  onFrames: (frames: PoseFrame[]) => void = () => {};
  onState: () => Promise<void> = async () => {};
  private nextToast = 1;
  private showing: Promise<void> = Promise.resolve();
  private recalling: Promise<void> | null = null;
  /** Entries of the journal; those that the checkpoint stands for; whether one of the others takes long to play. */
  private written = 0;
  private kept = 0;
  private costly = false;

  constructor(
    readonly engine: EngineClient,
    private readonly journal: Journal,
  ) {}

  /** Runs a command, shows its outcome and writes it to the journal; a failure is told in words and changes nothing. */
  run(command: Command, bytes?: Uint8Array): Promise<Change | null> {
    return this.whileBusy(async () => {
      try {
        if (this.recalling) await this.recalling;
        const copy = bytes?.slice();
        const change = await this.engine.commit(command, bytes);
        // Replies come in the order of the commands: written down at once, the journal is in order too.
        this.write({ kind: 'commit', command, ...(copy ? { bytes: copy } : {}) });
        await this.accept(change);
        if (change.solved) this.solvedStroke.value = 'stroke' in command ? command.stroke : (this.state.value.strokes.at(-1)?.id ?? null);
        if (change.notice) this.tell(change.notice);
        return change;
      } catch (error) {
        this.tell((error as Error).message, 'error');
        await this.endPreview();
        return null;
      }
    });
  }

  preview(command: Command): void {
    const sent = performance.now();
    this.engine.preview(
      command,
      (change) => {
        const elapsed = performance.now() - sent;
        this.timings.push({ ...change.timing, transfer_ms: Math.max(0, elapsed - change.timing.engine_ms) });
        if (this.timings.length > 600) this.timings.shift();
        this.solved.value = change.solved;
        this.onFrames(change.frames);
      },
      (error: EngineError) => {
        // A line that is still too short to solve is no fault of the person who draws it.
        if (error.code === 'internal') this.tell(error.message, 'error');
      },
    );
  }

  /** Takes a character in hand. */
  take(actor: number): void {
    batch(() => {
      this.actor.value = actor;
      this.joint.value = null;
      this.picked.value = [];
      this.stroke.value = null;
    });
  }

  /** Selects a line, and takes its character in hand; or none. */
  takeStroke(stroke: number | null): void {
    const actor = this.state.peek().strokes.find((s) => s.id === stroke)?.actor;
    if (actor !== undefined && actor !== this.actor.peek()) this.take(actor);
    this.stroke.value = stroke;
  }

  /** How bodies are skinned: it changes nothing but what is shown. */
  skinBy(dual: boolean): Promise<void> {
    return this.whileBusy(async () => this.onFrames((await this.engine.skinning(dual)).frames));
  }

  endPreview(): Promise<void> {
    return this.whileBusy(async () => {
      const change = await this.engine.cancelPreview();
      this.solved.value = null;
      this.onFrames(change.frames);
    });
  }

  /** Asks the engine what joints picked by hand make. */
  async checkPicked(joints: number[], actor: number): Promise<void> {
    let answer = { valid: true, message: '', segments: [] as number[][] };
    if (joints.length > 1) {
      answer = await this.engine
        .query<typeof answer>('selection', { actor, joints })
        .catch((error: Error) => ({ valid: false, message: error.message, segments: [] }));
    }
    if (joints !== this.picked.value) return; // others have been picked since
    batch(() => {
      this.segments.value = answer.segments;
      this.pickedFault.value = answer.message;
    });
  }

  undo = async (): Promise<void> => {
    if (this.earlier.peek() && this.state.peek().undo === '') await (this.recalling ??= this.recall());
    await this.step('undo');
  };
  redo = (): Promise<void> => this.step('redo');

  /** Fetches what an earlier visit left, and says whether there was anything: the project as it was last kept and the
      steps since then, or else every step. */
  async replay(): Promise<boolean> {
    return this.whileBusy(async () => {
      const checkpoint = await this.journal.checkpoint();
      const since = await this.journal.entries(checkpoint?.entries ?? 0);
      let entries = since;
      if (checkpoint && stepsStayAbove(since) && (await this.restore(checkpoint))) {
        this.kept = this.written = checkpoint.entries;
        this.earlier.value = true;
      } else if (checkpoint) {
        entries = await this.journal.entries(0);
      }
      await this.play(entries);
      await this.refresh();
      return this.written > 0;
    });
  }

  /** Keeps the project as it stands beside the journal, if it is worth it and nothing is going on: the next visit then
      starts from there. Undo still reaches every step before. */
  async keepCheckpoint(): Promise<void> {
    const worth = this.costly || this.written - this.kept >= CHECKPOINT_AFTER;
    if (!worth || this.busy.peek() > 0 || this.state.peek().redo !== '') return;
    const entries = this.written;
    const project = await this.engine.export('croquis', 0);
    await this.journal.keep({ project, entries });
    this.kept = entries;
    this.costly = false;
  }

  /** Plays every step of the journal again, so that undo reaches those before the checkpoint. */
  private async recall(): Promise<void> {
    await this.whileBusy(async () => {
      this.tell(t('recalling'));
      await this.engine.cancelPreview(); // what was under way is answered, and so in the journal
      const entries = await this.journal.entries(0);
      await this.engine.begin();
      this.written = 0;
      await this.play(entries);
      this.earlier.value = false;
      this.recalling = null;
    });
  }

  private async restore(checkpoint: Checkpoint): Promise<boolean> {
    try {
      const change = await this.engine.restore(checkpoint.project);
      if (change.state) this.state.value = change.state;
      return true;
    } catch {
      return false; // of another version, perhaps: the journal has it all
    }
  }

  /** What cannot be played any more is told and left out. */
  private async play(entries: Entry[]): Promise<void> {
    let state = this.state.peek();
    for (const entry of entries) {
      try {
        const change =
          entry.kind === 'commit' ? await this.engine.commit(entry.command, entry.bytes?.slice()) : await this.engine[entry.kind]();
        state = change.state ?? state;
      } catch (error) {
        this.tell((error as Error).message, 'error');
      }
      this.count(entry);
    }
    this.state.value = state;
  }

  private write(entry: Entry): void {
    this.count(entry);
    void this.journal.append(entry);
  }

  private count(entry: Entry): void {
    this.written += 1;
    this.costly ||= entry.kind === 'commit' && /^(add_character|open|set_proportions)$/.test(entry.command.name);
  }

  private async refresh(): Promise<void> {
    await this.show();
    const change = await this.engine.cancelPreview();
    this.onFrames(change.frames);
    this.mendSelection();
  }

  /** One after the other: a character whose buffers are still coming may be taken away meanwhile. */
  private async show(): Promise<void> {
    const shown = this.showing.then(() => this.onState());
    this.showing = shown.catch(() => {});
    await shown;
  }

  tell(text: string, kind: Toast['kind'] = 'note'): void {
    const toast = { id: this.nextToast++, text, kind };
    this.toasts.value = [...this.toasts.value.slice(-2), toast];
    setTimeout(() => this.dismiss(toast.id), kind === 'error' ? 9000 : 4000);
  }

  dismiss(id: number): void {
    this.toasts.value = this.toasts.value.filter((toast) => toast.id !== id);
  }

  private step(kind: 'undo' | 'redo'): Promise<void> {
    return this.whileBusy(async () => {
      if (this.recalling) await this.recalling;
      const change = await this.engine[kind]();
      // Only now: the label of before a command that was still on its way says nothing.
      if (this.state.value[kind] !== '') this.write({ kind });
      await this.accept(change);
    });
  }

  private async whileBusy<T>(work: () => Promise<T>): Promise<T> {
    this.busy.value = this.busy.peek() + 1; // whoever asks in an effect does not wait for it
    try {
      return await work();
    } finally {
      this.busy.value = this.busy.peek() - 1;
    }
  }

  private async accept(change: Change): Promise<void> {
    batch(() => {
      if (change.state) this.state.value = change.state;
      this.solved.value = change.solved;
    });
    if (change.state) await this.show();
    this.onFrames(change.frames);
    this.mendSelection();
  }

  /** What was selected may be gone. */
  private mendSelection(): void {
    const { actors, strokes } = this.state.value;
    batch(() => {
      if (!actors.some((a) => a.id === this.actor.value)) {
        this.actor.value = actors[0]?.id ?? 0;
        this.joint.value = null;
        this.picked.value = [];
      }
      if (!strokes.some((s) => s.id === this.stroke.value)) this.stroke.value = null;
    });
  }
}
