import { useEffect, useLayoutEffect } from "preact/hooks";
import { setPath, turnFormation } from "../../document/commands/travel";
import { barycenterOf } from "../../document/formation";
import { mainTrack, type Segment } from "../../document/scene";
import { snapOf } from "../../document/snap";
import { endsAround } from "../../document/stretches";
import { formatAngle, lengthWithUnit } from "../../document/units";
import { bowBetween, crosses, curveThrough, followed, lengthAlong, turnAlong, turnBetween } from "../../shapes/travel";
import { Row } from "../controls/row";
import { Section } from "../inspector/section";
import { useStudio } from "../studio";
import { penOn } from "./pen";
import { penWords } from "./pen-words";

/** Turns below this are a trembling hand's, radians: 3°. */
const LEAST_TURN = 0.05;

/** The path that a transition's formation travels along: drawn, drawn anew, taken away. */
export function PathPart({ index, segment }: { index: number; segment: Segment }) {
  const { document, messages, playback, view, aside } = useStudio();
  const scene = document.scene.value;
  const track = mainTrack(scene);
  const { keyframes, agents } = track;
  const [from, to] = endsAround(track, index).map((end) => keyframes[end]?.positions);
  const isDrawing = penOn.value === index;
  const isSeen = isDrawing || segment.path !== null;
  const isFree = aside.value === null;

  // What is drawn over the stage is there while the transition is looked at and nothing else is beside the show.
  useEffect(() => {
    if (isSeen && isFree) aside.value = { kind: "path" };
    if (!isSeen && aside.peek()?.kind === "path") aside.value = null;
  }, [isSeen, isFree]);
  useEffect(
    () => () => {
      penOn.value = null;
      if (aside.peek()?.kind === "path") aside.value = null;
    },
    [],
  );
  // Keys are heard here, where the button was pressed: what is drawn on may still be on its way. And from the moment that is said:
  // a key that follows at once would press the button again.
  useLayoutEffect(() => {
    if (!isDrawing || !from || !to) return;
    const [start, end] = [barycenterOf(from), barycenterOf(to)];
    function onKeyDown(event: KeyboardEvent): void {
      if (event.defaultPrevented || (event.key !== "Escape" && event.key !== "Enter")) return;
      event.preventDefault();
      penOn.value = null;
      if (event.key === "Enter") {
        document.perform(setPath(index, bowBetween(start, end, snapOf(document.scene.peek())), "Draw path"));
      }
    }
    addEventListener("keydown", onKeyDown, true);
    return () => removeEventListener("keydown", onKeyDown, true);
  }, [isDrawing, from, to]);
  if (!from || !to || agents.length === 0) return null;

  const line = segment.path && curveThrough(followed(segment.path, barycenterOf(from), barycenterOf(to)));
  const rest = line ? wrapped(turnAlong(line) - turnBetween(from, to)) : 0;

  function draw(): void {
    playback.pause();
    view.projection.value = "plan";
    penOn.value = isDrawing ? null : index;
    if (penOn.peek() !== null) messages.announce("Draw the path on the stage. Enter makes a bow, Escape gives up.");
  }

  return (
    <Section>
      <Row label="Path" {...(line ? { note: lengthWithUnit(lengthAlong(line), scene.stage.units, 1) } : {})}>
        <button type="button" class="button" aria-pressed={isDrawing} onClick={draw}>
          {segment.path ? "Draw another path" : "Draw a path"}
        </button>
      </Row>
      {isDrawing && (
        <p class="inspector-text" role="status">
          {penWords.value} Enter makes a bow, Escape gives up.
        </p>
      )}
      {line && !isDrawing && (
        <>
          <p class="inspector-text">{wordsOf(line)}</p>
          <div class="inspector-buttons">
            {Math.abs(rest) > LEAST_TURN && (
              <button
                type="button"
                class="button"
                onClick={() => document.perform(turnFormation(index + 1, rest))}
                title="The next formation as the path would have turned this one"
              >
                Turn the next along
              </button>
            )}
            <button type="button" class="button" onClick={() => document.perform(setPath(index, null, "Remove path"))}>
              Remove the path
            </button>
          </div>
        </>
      )}
    </Section>
  );
}

/** What the path does to the formation. */
function wordsOf(line: readonly (readonly [number, number])[]): string {
  const turn = turnAlong(line);
  const side = turn > 0 ? "left" : "right";
  const turning =
    Math.abs(turn) > LEAST_TURN
      ? `The formation turns with it, in all ${formatAngle(Math.abs(turn))} to the ${side}.`
      : "The formation turns with it, and ends as it set out.";
  return crosses(line) ? `${turning} It crosses itself: they pass there twice.` : turning;
}

/** Into half a turn either way. */
function wrapped(angle: number): number {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}
