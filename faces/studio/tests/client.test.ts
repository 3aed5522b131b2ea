// SPDX-License-Identifier: MIT
import { describe, expect, it } from 'vitest';
import { EngineClient, EngineError, type Wire } from '../src/engine/client';
import type { Reply, Request } from '../src/engine/messages';
import type { Command } from '../src/engine/protocol';

class FakeWire implements Wire {
  onmessage: ((event: MessageEvent<Reply>) => void) | null = null;
  readonly sent: { id: number; request: Request }[] = [];
  postMessage(message: { id: number; request: Request }): void {
    this.sent.push(message);
  }
  answer(reply: Reply): Promise<void> {
    this.onmessage?.({ data: reply } as MessageEvent<Reply>);
    return new Promise((resolve) => setTimeout(resolve));
  }
}

const reset = (amount: number): Command => ({ name: 'reset', actor: 0, joints: [], amount });

describe('engine client', () => {
  it('sends only the newest of the previews that wait', async () => {
    const wire = new FakeWire();
    const client = new EngineClient(wire);
    const shown: unknown[] = [];
    for (const amount of [0.1, 0.2, 0.3]) client.preview(reset(amount), (change) => shown.push(change), () => {});
    expect(wire.sent.length).toBe(1);
    await wire.answer({ id: wire.sent[0]!.id, result: 'first' });
    expect(wire.sent.length).toBe(2);
    expect((wire.sent[1]!.request as { command: Command }).command).toEqual(reset(0.3));
    await wire.answer({ id: wire.sent[1]!.id, result: 'third' });
    expect(shown).toEqual(['first', 'third']);
    expect(wire.sent.length).toBe(2);
  });

  it('drops a waiting preview when a commit is made, and keeps commits in order', async () => {
    const wire = new FakeWire();
    const client = new EngineClient(wire);
    client.preview(reset(0.1), () => {}, () => {});
    client.preview(reset(0.2), () => {}, () => {});
    const first = client.commit(reset(0.5));
    const second = client.commit(reset(0.6));
    for (const { id } of [...wire.sent]) await wire.answer({ id, result: id });
    expect(wire.sent.map((message) => message.request.kind)).toEqual(['preview', 'commit', 'commit']);
    expect(await first).toBeLessThan((await second) as unknown as number);
  });

  it('turns a failure into an error with code and words', async () => {
    const wire = new FakeWire();
    const client = new EngineClient(wire);
    const outcome = client.undo().catch((error: Error) => error);
    await wire.answer({ id: wire.sent[0]!.id, failure: { code: 'bad_file', message: '/nodes/3: wanted a number' } });
    const error = await outcome;
    expect(error).toBeInstanceOf(EngineError);
    expect(error).toMatchObject({ code: 'bad_file', message: '/nodes/3: wanted a number' });
  });
});
