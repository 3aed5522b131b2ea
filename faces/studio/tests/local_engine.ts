// SPDX-License-Identifier: MIT
// The real engine in this very process: the worker's wire without the worker.
import { readFileSync } from 'node:fs';
import { EngineClient, type Wire } from '../src/engine/client';
import { replyTo, type Seat } from '../src/engine/answers';
import type { Reply, Request } from '../src/engine/messages';
import createModule from '../wasm/croquis.mjs';

class LocalWire implements Wire {
  onmessage: ((event: MessageEvent<Reply>) => void) | null = null;
  constructor(private readonly seat: Seat) {}
  postMessage({ id, request }: { id: number; request: Request }): void {
    const reply = replyTo(this.seat, id, structuredClone(request));
    queueMicrotask(() => this.onmessage?.({ data: reply } as MessageEvent<Reply>));
  }
}

export async function startLocalEngine(): Promise<EngineClient> {
  const wasmBinary = readFileSync(new URL('../wasm/croquis.wasm', import.meta.url));
  const module = await createModule({ wasmBinary });
  return new EngineClient(new LocalWire({ table: new module.Table(), dual: false }));
}
