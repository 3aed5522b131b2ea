// SPDX-License-Identifier: MIT
// Decides what a pointer means: draw with the tool, or navigate. Knows no DOM beyond the fields it reads, so that its
// rules can be tested one by one:
//   pen and left button use the tool; right or middle button, Alt or Space orbit, with Shift they pan;
//   one finger uses the tool until a pen has been seen, then it orbits; two fingers always navigate;
//   a tap of two fingers undoes, of three redoes; touch is ignored while a pen is down (the palm);
//   while the tool is at work the camera is locked.

export interface PointerSample {
  id: number;
  type: string; // 'mouse' | 'pen' | 'touch'
  button: number;
  x: number;
  y: number;
  time: number; // milliseconds
  pressure: number;
  alt: boolean;
  shift: boolean;
  space: boolean;
}

export interface GestureActions {
  toolDown(sample: PointerSample): void;
  toolMove(samples: PointerSample[]): void;
  toolUp(sample: PointerSample): void;
  toolCancel(): void;
  hover(sample: PointerSample): void;
  orbit(dx: number, dy: number): void;
  pan(dx: number, dy: number): void;
  zoom(factor: number): void;
  undo(): void;
  redo(): void;
}

type State =
  | { path: 'idle' }
  | { path: 'tool'; id: number; type: string; moved: number }
  | { path: 'orbit' | 'pan'; id: number }
  | { path: 'fingers'; most: number; moved: number; since: number };

const TAP_MS = 300;
const TAP_PX = 12;

export class Gestures {
  private state: State = { path: 'idle' };
  private readonly down = new Map<number, PointerSample>();
  private penSeen = false;

  constructor(private readonly actions: GestureActions) {}

  /** The active state, as text: 'idle', 'tool', 'orbit', 'pan' or 'fingers'. */
  get path(): string {
    return this.state.path;
  }

  /** Whether the pointer is wanted (and should be captured). */
  pointerDown(p: PointerSample): boolean {
    if (p.type === 'pen') this.penSeen = true;
    const penIsDown = this.state.path === 'tool' && this.state.type === 'pen';
    if (p.type === 'touch' && penIsDown) return false; // a palm
    if (p.type === 'pen' && this.state.path !== 'idle') this.dropFingers();
    this.down.set(p.id, p);
    if (p.type === 'touch') return this.touchDown(p);
    if (this.state.path !== 'idle') return false;
    if (p.button === 0 && !p.alt && !p.space) this.startTool(p);
    else this.state = { path: p.shift ? 'pan' : 'orbit', id: p.id };
    return true;
  }

  pointerMove(p: PointerSample, coalesced: PointerSample[] = [p]): void {
    const last = this.down.get(p.id);
    if (!last) {
      if (this.state.path === 'idle') this.actions.hover(p);
      return;
    }
    const before = this.spread();
    this.down.set(p.id, p);
    const [dx, dy] = [p.x - last.x, p.y - last.y];
    const state = this.state;
    if (state.path === 'tool' && state.id === p.id) {
      state.moved += Math.hypot(dx, dy);
      this.actions.toolMove(coalesced);
    } else if ((state.path === 'orbit' || state.path === 'pan') && state.id === p.id) {
      this.actions[state.path](dx, dy);
    } else if (state.path === 'fingers') {
      this.fingersMoved(state, before, dx, dy);
    }
  }

  pointerUp(p: PointerSample): void {
    const known = this.down.delete(p.id);
    if (!known) return;
    const state = this.state;
    if (state.path === 'tool' && state.id === p.id) {
      this.state = { path: 'idle' };
      this.actions.toolUp(p);
    } else if ((state.path === 'orbit' || state.path === 'pan') && state.id === p.id) {
      this.state = { path: 'idle' };
    } else if (state.path === 'fingers' && this.down.size === 0) {
      this.state = { path: 'idle' };
      const isTap = p.time - state.since < TAP_MS && state.moved < TAP_PX;
      if (isTap && state.most === 2) this.actions.undo();
      if (isTap && state.most === 3) this.actions.redo();
    }
  }

  /** The system took the pointer away (a notification, a swipe from the edge): nothing must stay half done. */
  pointerCancel(p: PointerSample): void {
    this.down.delete(p.id);
    if (this.state.path === 'tool' && this.state.id === p.id) this.actions.toolCancel();
    if (this.down.size === 0 || this.state.path !== 'fingers') this.state = { path: 'idle' };
  }

  /** Escape. */
  cancel(): void {
    if (this.state.path === 'tool') this.actions.toolCancel();
    this.state = { path: 'idle' };
    this.down.clear();
  }

  wheel(deltaY: number): void {
    if (this.state.path !== 'tool') this.actions.zoom(Math.exp(Math.max(-1, Math.min(1, deltaY * 0.0015))));
  }

  private touchDown(p: PointerSample): boolean {
    const fingers = this.down.size;
    if (fingers === 1 && this.state.path === 'idle') {
      if (this.penSeen) this.state = { path: 'orbit', id: p.id };
      else this.startTool(p);
      return true;
    }
    // A second finger turns what the first began into navigation.
    if (this.state.path === 'tool') this.actions.toolCancel();
    if (this.state.path === 'fingers') this.state.most = Math.max(this.state.most, fingers);
    else this.state = { path: 'fingers', most: fingers, moved: 0, since: p.time };
    return true;
  }

  private startTool(p: PointerSample): void {
    this.state = { path: 'tool', id: p.id, type: p.type, moved: 0 };
    this.actions.toolDown(p);
  }

  private dropFingers(): void {
    if (this.state.path === 'tool') this.actions.toolCancel();
    this.down.clear();
    this.state = { path: 'idle' };
  }

  private spread(): number {
    const [a, b] = [...this.down.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  }

  private fingersMoved(state: State & { path: 'fingers' }, before: number, dx: number, dy: number): void {
    state.moved += Math.hypot(dx, dy);
    if (state.moved < TAP_PX / 2) return;
    const count = Math.max(1, this.down.size);
    if (count === 2) this.actions.orbit(dx / count, dy / count);
    else this.actions.pan(dx / count, dy / count);
    const after = this.spread();
    if (count === 2 && before > 0 && after > 0) this.actions.zoom(before / after);
  }
}
