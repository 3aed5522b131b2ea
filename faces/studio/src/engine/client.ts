// SPDX-License-Identifier: MIT
// The page's side of the wire. Commits run in the order they were made; of previews only the newest that waits is
// ever sent, so that a slow solve never queues up behind the pen.
import type { Change, PartGeometry, Reply, Request } from './messages';
import type { Command, EngineFailure, ExportFormat, PoseFrame } from './protocol';

/** A failure in the engine's words. */
export class EngineError extends Error {
  readonly code: string;
  constructor(failure: EngineFailure) {
    super(failure.message);
    this.name = 'EngineError';
    this.code = failure.code;
  }
}

/** What the client needs of a Worker; a test gives it something simpler. */
export interface Wire {
  postMessage(message: { id: number; request: Request }, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent<Reply>) => void) | null;
}

interface Waiting {
  resolve(value: unknown): void;
  reject(error: Error): void;
}

export class EngineClient {
  private next = 1;
  private readonly waiting = new Map<number, Waiting>();
  private previewBusy = false;
  private newestPreview: (() => void) | null = null;

  constructor(private readonly wire: Wire) {
    wire.onmessage = (event) => this.settle(event.data);
  }

  /** Forgets everything, history too. */
  async begin(): Promise<void> {
    await this.send({ kind: 'begin' });
  }

  commit(command: Command, bytes?: Uint8Array): Promise<Change> {
    this.newestPreview = null; // what was only a preview is over
    return this.send(bytes ? { kind: 'commit', command, bytes } : { kind: 'commit', command }) as Promise<Change>;
  }

  undo(): Promise<Change> {
    return this.send({ kind: 'undo' }) as Promise<Change>;
  }

  redo(): Promise<Change> {
    return this.send({ kind: 'redo' }) as Promise<Change>;
  }

  /** Whether the outcome of a preview is still to come. */
  get previewing(): boolean {
    return this.previewBusy;
  }

  /** Calls `shown` with the preview's outcome, unless a newer preview or a commit has overtaken it. */
  preview(command: Command, shown: (change: Change) => void, failed: (error: EngineError) => void): void {
    const run = (): void => {
      this.previewBusy = true;
      this.send({ kind: 'preview', command })
        .then((change) => shown(change as Change), (error: EngineError) => failed(error))
        .finally(() => {
          this.previewBusy = false;
          const newest = this.newestPreview;
          this.newestPreview = null;
          newest?.();
        });
    };
    if (this.previewBusy) this.newestPreview = run;
    else run();
  }

  cancelPreview(): Promise<Change> {
    this.newestPreview = null;
    return this.send({ kind: 'cancel' }) as Promise<Change>;
  }

  /** From now on poses come for blending by dual quaternions, or by matrices. */
  skinning(dual: boolean): Promise<Change> {
    return this.send({ kind: 'skinning', dual }) as Promise<Change>;
  }

  /** How an actor would stand after each command; null where the command fails. Nothing is changed or shown. */
  poseFrames(commands: Command[]): Promise<(PoseFrame | null)[]> {
    return this.send({ kind: 'pose_frames', commands }) as Promise<(PoseFrame | null)[]>;
  }

  geometry(actor: number, part: number): Promise<PartGeometry> {
    return this.send({ kind: 'geometry', actor, part }) as Promise<PartGeometry>;
  }

  /** Where the engine itself puts the vertices of a part: what the graphics card has to come up with. */
  vertices(actor: number, part: number): Promise<Float32Array> {
    return this.send({ kind: 'vertices', actor, part }) as Promise<Float32Array>;
  }

  export(format: ExportFormat, actor: number, options: Record<string, unknown> = {}): Promise<Uint8Array> {
    return this.send({ kind: 'export', format, actor, options }) as Promise<Uint8Array>;
  }

  query<T>(name: string, args: Record<string, unknown> = {}): Promise<T> {
    return this.send({ kind: 'query', name, args }) as Promise<T>;
  }

  restore(bytes: Uint8Array): Promise<Change> {
    return this.send({ kind: 'restore', bytes }) as Promise<Change>;
  }

  private send(request: Request): Promise<unknown> {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.wire.postMessage({ id, request });
    });
  }

  private settle(reply: Reply): void {
    const waiting = this.waiting.get(reply.id);
    this.waiting.delete(reply.id);
    if (reply.failure) waiting?.reject(new EngineError(reply.failure));
    else waiting?.resolve(reply.result);
  }
}

export function startEngine(): EngineClient {
  return new EngineClient(new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' }) as unknown as Wire);
}
