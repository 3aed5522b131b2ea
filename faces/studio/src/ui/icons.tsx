// SPDX-License-Identifier: MIT
// The page's own icons: one path each on a 24-unit square, drawn with the pen's round caps.
const PATHS = {
  draw: 'M4 19c3-1 3-5 6-6s3 4 6 2 2-7 4-10',
  drag: 'M12 3v18M3 12h18M12 3l-3 3m3-3 3 3M12 21l-3-3m3 3 3-3M3 12l3-3m-3 3 3 3M21 12l-3-3m3 3-3 3',
  rotate: 'M20 12a8 8 0 1 1-2.6-5.9M20 3v4.5h-4.5',
  select: 'M5 3l14 8-6 1.6L10 19z',
  undo: 'M9 7L4 12l5 5M4 12h10a6 6 0 0 1 6 6',
  redo: 'M15 7l5 5-5 5M20 12H10a6 6 0 0 0-6 6',
  menu: 'M4 7h16M4 12h16M4 17h16',
  mirror: 'M12 3v18M9 7L3 17h6zM15 7l6 10h-6z',
  frame: 'M4 8V4h4M16 4h4v4M20 16v4h-4M8 20H4v-4M9 12a3 3 0 1 0 6 0 3 3 0 1 0-6 0',
  next: 'M9 5l7 7-7 7',
  previous: 'M15 5l-7 7 7 7',
  close: 'M6 6l12 12M18 6L6 18',
  eye: 'M2 12s4-7 10-7 10 7 10 7-4 7-10 7S2 12 2 12zM9 12a3 3 0 1 0 6 0 3 3 0 1 0-6 0',
  trash: 'M4 7h16M9 7V4h6v3M6 7l1 13h10l1-13M10 11v6M14 11v6',
  pin: 'M12 21v-7M7 14h10l-2-4V5h1V3H8v2h1v5z',
  keep: 'M6 3h12v18l-6-5-6 5z',
  search: 'M11 4a7 7 0 1 0 0 14 7 7 0 1 0 0-14M16 16l5 5',
  open: 'M3 6h6l2 3h10v10H3z',
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name }: { name: IconName }) {
  return (
    <svg class="icon" viewBox="0 0 24 24" aria-hidden="true" focusable="false">
      <path d={PATHS[name]} />
    </svg>
  );
}
