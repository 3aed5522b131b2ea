// SPDX-License-Identifier: MIT
// The engine's side of the wire: one wasm instance, one request at a time.
import createModule from '../../wasm/croquis.mjs';
import wasmUrl from '../../wasm/croquis.wasm?url';
import { replyTo, transfers, type Seat } from './answers';
import type { Reply, Request } from './messages';

const ready: Promise<Seat> = createModule({ locateFile: () => wasmUrl }).then((module) => ({ table: new module.Table(), dual: false }));

self.onmessage = async (event: MessageEvent<{ id: number; request: Request }>) => {
  const { id, request } = event.data;
  let reply: Reply;
  try {
    reply = replyTo(await ready, id, request);
  } catch (error) {
    reply = { id, failure: { code: 'internal', message: `the engine did not start: ${String(error)}` } };
  }
  (self as unknown as Worker).postMessage(reply, transfers(reply.result));
};
