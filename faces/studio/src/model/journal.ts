// SPDX-License-Identifier: MIT
// Every change, written down in the browser's storage as it is made: leaving a page cannot be awaited, so nothing is
// left to be saved when the tab closes. Playing the journal gives back the project with its undo history.
import type { Command } from '../engine/protocol';

export type Entry = { kind: 'commit'; command: Command; bytes?: Uint8Array } | { kind: 'undo' } | { kind: 'redo' };

export interface Journal {
  append(entry: Entry): Promise<void>;
  entries(): Promise<Entry[]>;
  clear(): Promise<void>;
}

export class MemoryJournal implements Journal {
  private readonly list: Entry[] = [];
  async append(entry: Entry): Promise<void> {
    this.list.push(structuredClone(entry));
  }
  async entries(): Promise<Entry[]> {
    return structuredClone(this.list);
  }
  async clear(): Promise<void> {
    this.list.length = 0;
  }
}

const STORE = 'entries';

function finished<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error('storage failed'));
  });
}

export class BrowserJournal implements Journal {
  private constructor(
    private readonly database: IDBDatabase,
    private readonly onFailure: (error: unknown) => void,
  ) {}

  static async open(name: string, onFailure: (error: unknown) => void): Promise<BrowserJournal> {
    const request = indexedDB.open(name, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(STORE, { autoIncrement: true });
    return new BrowserJournal(await finished(request), onFailure);
  }

  async append(entry: Entry): Promise<void> {
    try {
      const transaction = this.database.transaction(STORE, 'readwrite', { durability: 'relaxed' });
      await finished(transaction.objectStore(STORE).add(entry));
    } catch (error) {
      this.onFailure(error);
    }
  }

  entries(): Promise<Entry[]> {
    return finished(this.database.transaction(STORE, 'readonly').objectStore(STORE).getAll() as IDBRequest<Entry[]>);
  }

  async clear(): Promise<void> {
    await finished(this.database.transaction(STORE, 'readwrite').objectStore(STORE).clear());
  }
}

/** The browser's storage, or memory where there is none (a private window): then nothing outlives the tab. */
export async function openJournal(onFailure: (error: unknown) => void): Promise<Journal> {
  try {
    return await BrowserJournal.open('croquis', onFailure);
  } catch (error) {
    onFailure(error);
    return new MemoryJournal();
  }
}
