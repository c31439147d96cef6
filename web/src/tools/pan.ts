import type { ScreenPoint } from "../stage/camera";
import { NO_OVERLAY, type Tool } from "./tool";

type PanState = { readonly kind: "idle" } | { readonly kind: "panning"; readonly last: ScreenPoint };

const IDLE: PanState = { kind: "idle" };

/** Moves the view, never the scene. */
export const panTool: Tool<PanState> = {
  start: IDLE,
  step(state, event, editor) {
    switch (event.kind) {
      case "press":
        return { kind: "panning", last: event.screen };
      case "move":
        if (state.kind === "idle") return state;
        editor.panBy(event.screen.x - state.last.x, event.screen.y - state.last.y);
        return { kind: "panning", last: event.screen };
      default:
        return IDLE;
    }
  },
  overlay: () => NO_OVERLAY,
  cursor: (state) => (state.kind === "idle" ? "grab" : "grabbing"),
};
