// SPDX-License-Identifier: MIT
// All that the tests use of node.
declare module 'node:fs' {
  export function readFileSync(path: URL): Uint8Array<ArrayBuffer>;
}
