import "../dialogs/dialogs.css";
import "./shape-dialog.css";
import { useEffect, useMemo, useState } from "preact/hooks";
import type { Point } from "../../document/formation";
import { mainTrack, type Scene } from "../../document/scene";
import { snapOf } from "../../document/snap";
import { formatCount } from "../../document/units";
import type { ShapeRequest } from "../../engine/shape-protocol";
import { Segmented } from "../controls/segmented";
import type { ShapeOrigin } from "../dialogs/dialogs";
import { Frame } from "../dialogs/frame";
import type { DialogProps } from "../dialogs/host";
import { noteBefore, usePlacement } from "../stage-edge/use-placement";
import { useStudio } from "../studio";
import { OriginFields } from "./origin-fields";
import { ReadingFields, type ReadingOptions } from "./reading-fields";
import { refusalWords } from "./refusal-words";
import { SlotsPreview } from "./slots-preview";
import { type Origin, usePixels } from "./use-pixels";
import { shownOf, useSlots } from "./use-slots";

/** How much of the stage a shape takes each way. */
const SHARE = 0.8;
/** Agents that a shape has at first where they are added: enough to see what it is. */
const FIRST_COUNT = 200;
/** Two places can come this much nearer when both go to the lattice, in steps of it: √2, and a hair. */
const SNAPPED = 1.5;

const ORIGINS: { readonly [K in Origin["kind"]]: Origin } = {
  picture: { kind: "picture", file: null },
  text: { kind: "text", text: "", font: "" },
  path: { kind: "path", data: "" },
};

/** A formation from a picture, text or a path: how it will stand, and then it does. */
export function ShapeDialog({ request, dialogs }: DialogProps<ShapeOrigin>) {
  const { document, toolbox } = useStudio();
  const [origins, setOrigins] = useState(ORIGINS);
  const [kind, setKind] = useState<Origin["kind"]>(request.from);
  const [seed, setSeed] = useState(0);
  const [options, setOptions] = useState<ReadingOptions>({
    threshold: 0.5,
    isInverted: false,
    isOutline: false,
    count: FIRST_COUNT,
    size: null,
  });
  // A picture that is dropped or pasted while this is open comes as a new request.
  useEffect(() => {
    setKind(request.from);
    if (request.file) setOrigins((all) => ({ ...all, picture: { kind: "picture", file: request.file } }));
  }, [request]);

  const scene = document.scene.value;
  const ahead = usePlacement();
  const { placement } = ahead;
  const count = placement.kind === "add" ? options.count : placement.agents.length;
  const drawn = usePixels(origins[kind]);
  const pixels = drawn.kind === "here" ? drawn.pixels : null;
  const asked = useMemo((): ShapeRequest | null => {
    if (!pixels) return null;
    const { width, depth } = scene.stage;
    const { meters, parts } = snapOf(scene);
    const { minimumDistance } = scene;
    return {
      width: pixels.width,
      rgba: pixels.rgba,
      threshold: options.threshold,
      isInverted: options.isInverted,
      room: options.size === null ? [SHARE * width, SHARE * depth] : [options.size, options.size],
      count,
      leastDistance: minimumDistance > 0 ? minimumDistance + (SNAPPED * meters) / parts : 0,
      isOutline: options.isOutline,
      seed,
    };
  }, [pixels, scene, options, count, seed]);
  const slots = useSlots(asked);
  const xy = shownOf(slots);
  const says = wordsOf(drawn, slots, scene);
  const isPossible = slots.kind === "here" || slots.kind === "working";

  // Who presses while agents are still being arranged need not press again.
  const [isDue, setDue] = useState(false);
  useEffect(() => {
    if (isDue) place();
  }, [isDue, slots]);

  function place(): void {
    setDue(slots.kind === "working");
    if (slots.kind !== "here") return;
    const places = Array.from(
      { length: slots.xy.length / 2 },
      (_, i): Point => [slots.xy[2 * i] ?? 0, slots.xy[2 * i + 1] ?? 0],
    );
    toolbox.placeInView(places, `Place ${kind}`);
    dialogs.close();
  }

  function change(changes: Partial<ReadingOptions>): void {
    setDue(false);
    setOptions((before) => ({ ...before, ...changes }));
  }

  return (
    <Frame title="Shape" size="medium" lead="Agents stand evenly in what you give." onClose={dialogs.close}>
      <div class="shape-dialog">
        <SlotsPreview xy={xy} isOld={slots.kind !== "here"} />
        <div class="shape-fields">
          <Segmented<Origin["kind"]>
            label="Shape from"
            value={kind}
            choices={[
              { value: "picture", label: "Picture" },
              { value: "text", label: "Text" },
              { value: "path", label: "Path" },
            ]}
            onChoose={setKind}
          />
          <OriginFields
            origin={origins[kind]}
            onChange={(origin) => setOrigins((all) => ({ ...all, [origin.kind]: origin }))}
          />
          <ReadingFields
            options={{ ...options, count }}
            isPicture={kind === "picture"}
            isCountGiven={placement.kind === "place"}
            reason={noteBefore(ahead, mainTrack(scene).keyframes.length, count)}
            extent={xy && extentOf(xy)}
            units={scene.stage.units}
            onChange={change}
          />
          <p class="shape-says" role="status" data-tone={says.tone}>
            {says.text}
          </p>
        </div>
      </div>
      <div class="dialog-answers">
        <button
          type="button"
          class="button"
          aria-disabled={slots.kind !== "here"}
          onClick={() => slots.kind === "here" && setSeed(seed + 1)}
        >
          Arrange anew
        </button>
        <button type="button" class="button primary" aria-disabled={!isPossible} onClick={place}>
          {count === 1 ? "Place 1 agent" : `Place ${formatCount(count)} agents`}
        </button>
      </div>
    </Frame>
  );
}

/** The longer side of the box around places, meters. */
function extentOf(xy: Float64Array): number {
  const along = (axis: number) => xy.filter((_, k) => k % 2 === axis);
  const size = (values: Float64Array) =>
    values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b));
  return Math.max(size(along(0)), size(along(1)));
}

/** What is going on, or why there is nothing to place. */
function wordsOf(
  drawn: ReturnType<typeof usePixels>,
  slots: ReturnType<typeof useSlots>,
  { minimumDistance, stage }: Scene,
): { readonly tone: "plain" | "problem"; readonly text: string } {
  if (drawn.kind === "refused") return { tone: "problem", text: drawn.what };
  if (slots.kind === "refused") {
    return { tone: "problem", text: refusalWords(slots.problem, minimumDistance, stage.units) };
  }
  if (slots.kind === "working")
    return { tone: "plain", text: `Spreading agents, ${Math.round(100 * slots.progress)} %` };
  return { tone: "plain", text: drawn.kind === "here" ? drawn.pixels.note : drawn.what };
}
