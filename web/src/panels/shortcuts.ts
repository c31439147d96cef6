import type { ActionSection } from "./actions";

interface Listed {
  readonly section: ActionSection;
  readonly label: string;
  /** `Ctrl` means Cmd on a Mac; a key with more than one character is named as `KeyboardEvent.key`. The first is shown. */
  readonly keys?: readonly string[];
}

/** Everything a person can do, in the order of the help. The one table behind help, palette, tooltips and keyboard. */
export const SHORTCUTS = {
  "tool-select": { section: "Tools", label: "Select", keys: ["V"] },
  "tool-draw": { section: "Tools", label: "Draw", keys: ["D"] },
  "tool-shape": { section: "Tools", label: "Shape", keys: ["S"] },
  "tool-tie": { section: "Tools", label: "Tie", keys: ["T"] },
  "tool-group": { section: "Tools", label: "Group", keys: ["G"] },
  "tool-obstacle": { section: "Tools", label: "Obstacle", keys: ["O"] },
  "tool-pan": { section: "Tools", label: "Pan", keys: ["H"] },
  "shape-from-picture": { section: "Tools", label: "Shape from a picture" },
  "shape-from-text": { section: "Tools", label: "Shape from text" },
  "place-in-middle": { section: "Tools", label: "Place it in the middle, or close the polygon", keys: ["Enter"] },
  cancel: { section: "Tools", label: "Cancel or deselect", keys: ["Escape"] },

  play: { section: "Play", label: "Play or pause", keys: ["Space"] },
  "previous-keyframe": { section: "Play", label: "Previous keyframe", keys: ["Q"] },
  "next-keyframe": { section: "Play", label: "Next keyframe", keys: ["E"] },
  "go-to-start": { section: "Play", label: "Go to the start", keys: ["Home"] },
  "go-to-end": { section: "Play", label: "Go to the end", keys: ["End"] },
  loop: { section: "Play", label: "Loop", keys: ["L"] },
  counts: { section: "Play", label: "Counts and bars instead of seconds" },

  "add-keyframe": { section: "Keyframes", label: "Add keyframe", keys: ["K"] },
  "duplicate-keyframe": { section: "Keyframes", label: "Duplicate keyframe", keys: ["Shift+K"] },
  "delete-keyframe": { section: "Keyframes", label: "Delete keyframe" },
  "reverse-run": { section: "Keyframes", label: "Reverse run" },
  "repeat-run": { section: "Keyframes", label: "Repeat run" },

  undo: { section: "Edit", label: "Undo", keys: ["Ctrl+Z"] },
  redo: { section: "Edit", label: "Redo", keys: ["Ctrl+Shift+Z", "Ctrl+Y"] },
  "select-all": { section: "Edit", label: "Select all", keys: ["Ctrl+A"] },
  copy: { section: "Edit", label: "Copy", keys: ["Ctrl+C"] },
  paste: { section: "Edit", label: "Paste", keys: ["Ctrl+V"] },
  duplicate: { section: "Edit", label: "Duplicate", keys: ["Ctrl+D"] },
  delete: { section: "Edit", label: "Delete", keys: ["Delete", "Backspace"] },
  "nudge-left": { section: "Edit", label: "Nudge left", keys: ["ArrowLeft"] },
  "nudge-right": { section: "Edit", label: "Nudge right", keys: ["ArrowRight"] },
  "nudge-up": { section: "Edit", label: "Nudge up", keys: ["ArrowUp"] },
  "nudge-down": { section: "Edit", label: "Nudge down", keys: ["ArrowDown"] },
  "push-left": { section: "Edit", label: "Nudge far left", keys: ["Shift+ArrowLeft"] },
  "push-right": { section: "Edit", label: "Nudge far right", keys: ["Shift+ArrowRight"] },
  "push-up": { section: "Edit", label: "Nudge far up", keys: ["Shift+ArrowUp"] },
  "push-down": { section: "Edit", label: "Nudge far down", keys: ["Shift+ArrowDown"] },
  "nudge-higher": { section: "Edit", label: "Lift", keys: ["PageUp"] },
  "nudge-lower": { section: "Edit", label: "Lower", keys: ["PageDown"] },
  "push-higher": { section: "Edit", label: "Lift far", keys: ["Shift+PageUp"] },
  "push-lower": { section: "Edit", label: "Lower far", keys: ["Shift+PageDown"] },
  "rotate-left": { section: "Edit", label: "Rotate left by 15°", keys: ["["] },
  "rotate-right": { section: "Edit", label: "Rotate right by 15°", keys: ["]"] },
  "flip-horizontal": { section: "Edit", label: "Flip horizontally", keys: ["Shift+H"] },
  "flip-vertical": { section: "Edit", label: "Flip vertically", keys: ["Shift+V"] },
  "align-left": { section: "Edit", label: "Align left" },
  "align-center": { section: "Edit", label: "Align centers" },
  "align-right": { section: "Edit", label: "Align right" },
  "align-top": { section: "Edit", label: "Align top" },
  "align-middle": { section: "Edit", label: "Align middles" },
  "align-bottom": { section: "Edit", label: "Align bottom" },
  "distribute-horizontally": { section: "Edit", label: "Distribute horizontally" },
  "distribute-vertically": { section: "Edit", label: "Distribute vertically" },

  "make-group": { section: "Groups", label: "Make group", keys: ["Ctrl+G"] },
  "dissolve-group": { section: "Groups", label: "Dissolve group", keys: ["Ctrl+Shift+G"] },
  "tie-selected": { section: "Groups", label: "Tie the two selected agents" },
  "tie-group": { section: "Groups", label: "Tie group ten times as firm" },

  "use-everywhere": { section: "Transition", label: "Use these options for every transition" },
  compare: { section: "Transition", label: "Compare methods" },

  front: { section: "View", label: "Plan or front", keys: ["F"] },
  perspective: { section: "View", label: "Plan or perspective", keys: ["P"] },
  fit: { section: "View", label: "Fit", keys: ["Shift+1"] },
  "zoom-in": { section: "View", label: "Zoom in", keys: ["+", "="] },
  "zoom-out": { section: "View", label: "Zoom out", keys: ["-"] },
  "show-ties": { section: "View", label: "Show ties" },
  "show-trails": { section: "View", label: "Show trails" },
  "show-ghosts": { section: "View", label: "Show ghosts" },
  "show-groups": { section: "View", label: "Show groups" },
  "show-names": { section: "View", label: "Show names" },
  modes: { section: "View", label: "Modes" },
  recording: { section: "View", label: "Recording" },
  theme: { section: "View", label: "Light or dark" },

  new: { section: "File", label: "New" },
  open: { section: "File", label: "Open", keys: ["Ctrl+O"] },
  save: { section: "File", label: "Save", keys: ["Ctrl+S"] },
  export: { section: "File", label: "Export" },
  share: { section: "File", label: "Share" },
  examples: { section: "File", label: "Examples" },

  palette: { section: "Help", label: "Commands", keys: ["Ctrl+K"] },
  help: { section: "Help", label: "Help", keys: ["?"] },
} as const satisfies Readonly<Record<string, Listed>>;

export type ActionId = keyof typeof SHORTCUTS;

export function keysOf(id: ActionId): readonly string[] {
  const listed: Listed = SHORTCUTS[id];
  return listed.keys ?? [];
}
