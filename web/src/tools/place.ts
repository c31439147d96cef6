import { addAgents, placeAgents } from "../document/commands/agents";
import { Formation, type Point } from "../document/formation";
import { mostAgents } from "../document/limits";
import { type Placement, placementAt } from "../document/placement";
import { mainTrack, type Scene } from "../document/scene";
import { snapApart, snapOf } from "../document/snap";
import { liesBetween } from "../document/stretches";
import { formatCount } from "../document/units";
import { placeShape, type ShapeName } from "../shapes/shape";
import type { Spacing } from "../shapes/spacing";
import { toStage } from "../stage/camera";
import type { Editor } from "./tool";

/** What a stroke or shape does here: bring new agents, or place those there are. */
export function placementOf(editor: Editor): Placement {
  const { document, keyframe } = editor;
  return placementAt(document.scene.peek(), keyframe, document.selection.peek());
}

/** How many places a stroke or shape makes here: where the agents are given, exactly as many as they are. */
export function spacingFor(editor: Editor): Spacing {
  const placement = placementOf(editor);
  return placement.kind === "add" ? editor.spacing : { by: "count", count: placement.agents.length };
}

/**
 * Puts agents on the places of a finished stroke or shape; one undo entry.
 *
 * Where agents are given they take the places at once, in order, and then each the one that makes all ways together
 * shortest, seen from the keyframe before. Resolves when they stand.
 */
export async function settlePlaces(editor: Editor, places: readonly Point[], label: string): Promise<void> {
  const scene = editor.document.scene.peek();
  const slots = snapApart(places, snapOf(scene));
  const placement = placementOf(editor);
  if (placement.kind === "add") {
    addPlaces(editor, slots, label);
    return;
  }
  const { agents } = placement;
  if (slots.length !== agents.length) return;
  const { keyframe } = editor;
  const before = mainTrack(scene).keyframes[keyframe - 1]?.positions;
  const gesture = editor.document.beginGesture();
  gesture.preview(placeAgents(keyframe, agents, slots, Uint32Array.from(agents.keys()), label));
  const ends =
    liesBetween(mainTrack(scene), keyframe) && isEverybody(scene, agents) ? " A transition ends here now." : "";
  editor.announce(`${agents.length} agents placed. ${placement.reason}${ends}`);
  if (before) {
    const source = Formation.from(agents.map((agent) => before.point(agent)));
    try {
      const order = await editor.assign(source, Formation.from(slots));
      gesture.preview(placeAgents(keyframe, agents, slots, order, label));
    } catch {
      editor.warn(
        "The agents stand in the order drawn.",
        "The engine did not answer; undo and draw again for shorter ways.",
      );
    }
  }
  gesture.commit();
}

/** How much of what is seen a shape placed without a pointer takes, each way. */
const MIDDLE_SHARE = 0.4;

/** Puts a shape into the middle of what is seen of the stage; one undo entry. */
export function settleInMiddle(editor: Editor, shape: ShapeName): Promise<void> {
  const { size, camera } = editor;
  const corner = (share: number): Point => {
    const reach = (1 + share) / 2;
    return toStage(camera, { x: size.width * reach, y: size.height * reach });
  };
  const { places } = placeShape(shape, corner(-MIDDLE_SHARE), corner(MIDDLE_SHARE), spacingFor(editor));
  return settlePlaces(editor, places, `Place ${shape}`);
}

/** Puts places that are given about the middle of what is seen of the stage there; one undo entry. */
export function settleInView(editor: Editor, places: readonly Point[], label: string): Promise<void> {
  const { size, camera } = editor;
  const [x, y] = toStage(camera, { x: size.width / 2, y: size.height / 2 });
  return settlePlaces(
    editor,
    places.map((place): Point => [place[0] + x, place[1] + y]),
    label,
  );
}

function isEverybody(scene: Scene, agents: readonly number[]): boolean {
  return agents.length === mainTrack(scene).agents.length;
}

function addPlaces(editor: Editor, slots: readonly Point[], label: string): void {
  const scene = editor.document.scene.peek();
  const room = mostAgents(scene) - mainTrack(scene).agents.length;
  if (slots.length > room) {
    editor.warn(
      `${formatCount(slots.length)} agents are too many.`,
      `This show has room for ${formatCount(Math.max(0, room))} more.`,
    );
    return;
  }
  editor.document.perform(addAgents(slots, label));
  const isShow = mainTrack(scene).keyframes.length > 1;
  const count = slots.length === 1 ? "1 agent" : `${formatCount(slots.length)} agents`;
  editor.announce(`${count} added${isShow ? " to every keyframe" : ""}`);
}
