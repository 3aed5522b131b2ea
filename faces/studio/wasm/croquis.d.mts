// SPDX-License-Identifier: MIT
// What bindings.cpp exports, typed by hand: it changes when bindings.cpp does.

/** A view of engine memory; it dies when that memory grows: copy it at once. */
type View = Float32Array | Uint32Array | Uint16Array | Uint8Array;

export interface Table {
  begin(): void;
  execute(command: string, file: Uint8Array): string;
  preview(command: string): string;
  cancelPreview(): string;
  undo(): string;
  redo(): string;
  restore(project: Uint8Array): string;
  query(name: string, args: string): string;
  prepareExport(format: string, actor: number, options: string): string;
  exported(): Uint8Array;
  palette(actor: number, dual: boolean): Float32Array;
  jointPositions(actor: number): Float32Array;
  vertices(actor: number, part: number, dual: boolean): Float32Array;
  partInfo(actor: number, part: number): string;
  buffer(actor: number, part: number, what: string, shape: number): View;
  delete(): void;
}

export interface CroquisModule {
  Table: new () => Table;
}

export default function createModule(options?: {
  locateFile?: (file: string, prefix: string) => string;
  wasmBinary?: ArrayBufferLike | Uint8Array;
}): Promise<CroquisModule>;
