import { computed } from "@preact/signals";
import { NOTHING } from "../document/selection";
import type { Layers } from "../stage/view";
import type { ToolName } from "../tools/toolbox";
import type { ActionParts, Doing, Doings } from "./doing";

type ViewId =
  | `tool-${ToolName}`
  | "place-in-middle"
  | "cancel"
  | "front"
  | "perspective"
  | "fit"
  | "zoom-in"
  | "zoom-out"
  | `show-${keyof Layers}`
  | "theme";

const ZOOM_STEP = 1.25;

/** The tool in hand and how the stage is looked at: none of it is part of the scene. */
export function viewActions({ document, view, toolbox, messages, cancelGesture }: ActionParts): Doings<ViewId> {
  /** Tools work on the plan and from the front. */
  const tool = (name: ToolName): Doing => ({
    run() {
      toolbox.active.value = name;
      if (view.projection.peek() === "perspective") view.projection.value = "plan";
    },
  });

  const lens = () => view.lens.peek() ?? view;

  const layer = (name: keyof Layers): Doing => ({
    run() {
      const layers = view.layers.peek();
      view.layers.value = { ...layers, [name]: !layers[name] };
      messages.announce(`${name[0]?.toUpperCase()}${name.slice(1)} ${layers[name] ? "hidden" : "shown"}`);
    },
  });

  return {
    "tool-select": tool("select"),
    "tool-draw": tool("draw"),
    "tool-shape": tool("shape"),
    "tool-tie": tool("tie"),
    "tool-group": tool("group"),
    "tool-obstacle": tool("obstacle"),
    "tool-pan": tool("pan"),
    "place-in-middle": {
      isEnabled: computed(() => ["draw", "shape", "obstacle"].includes(toolbox.active.value)),
      run: () => toolbox.placeInMiddle(),
    },
    cancel: {
      run() {
        if (cancelGesture()) return;
        if (document.selection.peek().kind !== "none") document.selection.value = NOTHING;
        else toolbox.active.value = "select";
      },
    },
    front: {
      run() {
        const isFront = view.projection.peek() === "front";
        view.projection.value = isFront ? "plan" : "front";
        messages.announce(isFront ? "In plan" : "From the front");
      },
    },
    perspective: {
      run() {
        const isPerspective = view.projection.peek() === "perspective";
        view.projection.value = isPerspective ? "plan" : "perspective";
        messages.announce(isPerspective ? "In plan" : "In perspective");
      },
    },
    fit: { run: () => lens().fit() },
    "zoom-in": { run: () => lens().zoomBy(ZOOM_STEP) },
    "zoom-out": { run: () => lens().zoomBy(1 / ZOOM_STEP) },
    "show-ties": layer("ties"),
    "show-trails": layer("trails"),
    "show-ghosts": layer("ghosts"),
    "show-groups": layer("groups"),
    "show-names": layer("names"),
    theme: {
      run() {
        const dark = globalThis.matchMedia?.("(prefers-color-scheme: dark)").matches ?? false;
        const shown = view.theme.peek() === "system" ? (dark ? "dark" : "light") : view.theme.peek();
        view.theme.value = shown === "dark" ? "light" : "dark";
      },
    },
  };
}
