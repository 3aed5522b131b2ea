// SPDX-License-Identifier: MIT
// Every change, written down in the browser's storage as it is made: leaving a page cannot be awaited, so nothing is
// left to be saved when the tab closes. Playing the journal gives back the project with its undo history. Beside it lies
// now and then the project itself as it stood after so many entries: a visit starts from there, and plays the entries
// before it only if somebody undoes that far.
import type { Command } from '../engine/protocol';

export type Entry = { kind: 'commit'; command: Command; bytes?: Uint8Array } | { kind: 'undo' } | { kind: 'redo' };

/** A project file, and how many entries of the journal lead to it. */
export interface Checkpoint {
  project: Uint8Array;
  entries: number;
}

export interface Journal {
  append(entry: Entry): Promise<void>;
  /** Those that came after the first `after`. */
  entries(after: number): Promise<Entry[]>;
  checkpoint(): Promise<Checkpoint | null>;
  keep(checkpoint: Checkpoint): Promise<void>;
}

/** Whether no undo among these reaches below where they start. */
export function stepsStayAbove(entries: Entry[]): boolean {
  let depth = 0;
  let undone = 0;
  for (const { kind } of entries) {
    if (kind === 'commit') [depth, undone] = [depth + 1, 0];
    else if (kind === 'undo') [depth, undone] = [depth - 1, undone + 1];
    else if (undone > 0) [depth, undone] = [depth + 1, undone - 1];
    if (depth < 0) return false;
  }
  return true;
}

export class MemoryJournal implements Journal {
  private readonly list: Entry[] = [];
  private kept: Checkpoint | null = null;
  async append(entry: Entry): Promise<void> {
    this.list.push(structuredClone(entry));
  }
  async entries(after: number): Promise<Entry[]> {
    return structuredClone(this.list.slice(after));
  }
  async checkpoint(): Promise<Checkpoint | null> {
    return structuredClone(this.kept);
  }
  async keep(checkpoint: Checkpoint): Promise<void> {
    this.kept = structuredClone(checkpoint);
  }
}

const ENTRIES = 'entries'; // with keys that count from 1
const CHECKPOINT = 'checkpoint';

function finished<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error('storage failed'));
  });
}

export class BrowserJournal implements Journal {
  private constructor(
    private readonly database: IDBDatabase,
    private readonly onFailure: () => void,
  ) {}

  static async open(name: string, onFailure: () => void): Promise<BrowserJournal> {
    const request = indexedDB.open(name, 2);
    request.onupgradeneeded = () => {
      const stores = request.result.objectStoreNames;
      if (!stores.contains(ENTRIES)) request.result.createObjectStore(ENTRIES, { autoIncrement: true });
      if (!stores.contains(CHECKPOINT)) request.result.createObjectStore(CHECKPOINT);
    };
    return new BrowserJournal(await finished(request), onFailure);
  }

  async append(entry: Entry): Promise<void> {
    try {
      await finished(this.store(ENTRIES, 'readwrite').add(entry));
    } catch {
      this.onFailure();
    }
  }

  entries(after: number): Promise<Entry[]> {
    return finished(this.store(ENTRIES, 'readonly').getAll(IDBKeyRange.lowerBound(after, true)) as IDBRequest<Entry[]>);
  }

  async checkpoint(): Promise<Checkpoint | null> {
    return ((await finished(this.store(CHECKPOINT, 'readonly').get(0))) as Checkpoint | undefined) ?? null;
  }

  async keep(checkpoint: Checkpoint): Promise<void> {
    try {
      await finished(this.store(CHECKPOINT, 'readwrite').put(checkpoint, 0));
    } catch {
      // Only the next visit starts more slowly: the journal has it all.
    }
  }

  private store(name: string, mode: IDBTransactionMode): IDBObjectStore {
    return this.database.transaction(name, mode, { durability: 'relaxed' }).objectStore(name);
  }
}

/** Why nothing outlives this tab: the browser keeps nothing (a private window), or another tab has the table. */
export type NoStorage = 'storageFailed' | 'otherTab';

/** The browser's storage, or memory where there is none. */
export async function openJournal(onFailure: (why: NoStorage) => void): Promise<Journal> {
  if (!(await isOnlyTab())) {
    onFailure('otherTab');
    return new MemoryJournal();
  }
  try {
    return await BrowserJournal.open('croquis', () => onFailure('storageFailed'));
  } catch {
    onFailure('storageFailed');
    return new MemoryJournal();
  }
}

/** Two tabs that write one journal would make nonsense of it. The lock is held until the tab is gone; one that is just
    going (a reload) is waited for. */
function isOnlyTab(): Promise<boolean> {
  if (!('locks' in navigator)) return Promise.resolve(true);
  return new Promise((resolve) => {
    const hold = (): Promise<never> => {
      resolve(true);
      return new Promise<never>(() => {});
    };
    navigator.locks.request('croquis', { signal: AbortSignal.timeout(3000) }, hold).catch(() => resolve(false));
  });
}
