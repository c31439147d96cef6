import { computed, effect, type ReadonlySignal } from "@preact/signals";
import { useEffect, useMemo, useState } from "preact/hooks";
import { setTransition, type TransitionOptions } from "../../document/commands/transitions";
import type { Scene } from "../../document/scene";
import { createPlayback, type Playback } from "../../playback/playback";
import { fitting, type Padding } from "../../stage/camera";
import { createView } from "../../stage/create-view";
import { contentOf } from "../../stage/sheet";
import type { View } from "../../stage/view";
import { Select } from "../controls/select";
import { useStudio } from "../studio";
import { CompareTransport } from "./compare-transport";
import { measureRows } from "./measure-rows";
import { MeasureTable } from "./measure-table";
import { PRESETS } from "./presets";
import { SideColumn } from "./side-column";
import { commonStart, optionsOf, type Side, spanOf, type Trial, trialOf, withOptions } from "./sides";
import { type PlannedTrial, useTrial } from "./use-trial";

const OWN_CHOICE = "own";
const CHOICES = [
  { value: OWN_CHOICE, label: "Your own pair" },
  ...PRESETS.map(({ id, label }) => ({ value: id, label })),
];

/** CSS pixels about what is fitted: room for discs, hulls and ways that go around. */
const EDGES: Padding = { left: 40, right: 40, top: 40, bottom: 40 };

/** Both sides with one camera, one playhead, and a table of their numbers. */
export function Sides({ first, onDone }: { first: readonly [Side, Side]; onDone(): void }) {
  const { document, view: main, messages } = useStudio();
  const scene = document.scene.value;
  const [sides, setSides] = useState(first);
  const [preset, setPreset] = useState(OWN_CHOICE);
  const start = commonStart(scene, [sides[0].segment, sides[1].segment]);
  const playback = useSharedPlayback(first, start);
  const trials = useTrials(sides, start);
  const left = useTrial(trials[0], playback.time);
  const right = useTrial(trials[1], playback.time);
  // Both stages have one size, so that one camera serves both; theme and layers are the page's.
  const view = useMemo(() => ({ ...createView(left.scene), layers: main.layers, theme: main.theme }), [left, main]);
  useFit(view, left.scene);
  // One stage drives the time, the other follows.
  const following = useMemo((): Playback => ({ ...playback, tick() {} }), [playback]);

  const columns = [
    { name: "Left", side: sides[0], trial: trials[0], planned: left, playback },
    { name: "Right", side: sides[1], trial: trials[1], planned: right, playback: following },
  ] as const;

  function change(index: number, options: TransitionOptions): void {
    setPreset(OWN_CHOICE);
    setSides([
      index === 0 ? withOptions(sides[0], options) : sides[0],
      index === 1 ? withOptions(sides[1], options) : sides[1],
    ]);
  }

  function choose(id: string): void {
    setPreset(id);
    const chosen = PRESETS.find((candidate) => candidate.id === id);
    if (chosen) setSides([withOptions(sides[0], chosen.sides[0]), withOptions(sides[1], chosen.sides[1])]);
  }

  return (
    <div class="compare">
      {columns.map(({ name, side, trial, planned, playback: own }, index) => (
        <SideColumn
          key={name}
          name={name}
          side={side}
          trial={trial}
          planned={planned}
          playback={own}
          view={view}
          onChange={(options) => change(index, options)}
          onUse={() => {
            document.perform(setTransition(side.segment, optionsOf(side)));
            messages.announce(`The transition goes as on the ${name.toLowerCase()} now.`);
            onDone();
          }}
        />
      ))}
      <div class="compare-numbers">
        <Select label="What to compare" value={preset} choices={CHOICES} onChoose={choose} />
        <MeasureTable rows={measureRows(reportOf(left, trials[0]), reportOf(right, trials[1]), scene.stage.units)} />
        <p class="inspector-text">The better value has the weight. Less is better, except of clearance.</p>
      </div>
      <CompareTransport playback={playback} />
    </div>
  );
}

/** The formations fill both stages, which have no tools to keep clear of. */
function useFit(view: View, scene: ReadonlySignal<Scene>): void {
  useEffect(
    () =>
      effect(() => {
        const size = view.size.value;
        const content = contentOf(scene.peek());
        if (content && size.width > 0) view.camera.value = fitting(content, size, EDGES);
      }),
    [view, scene],
  );
}

/** A playhead over the longer of both, in a loop; it begins to play where that is welcome. */
function useSharedPlayback(sides: readonly [Side, Side], start: number): Playback {
  const { document, playback: main } = useStudio();
  const [shared] = useState(() => {
    const scene = document.scene.peek();
    const spans = sides.map(({ segment }) => spanOf(scene, segment));
    const length = Math.max(...spans.map((span) => span.end - span.start));
    const playback = createPlayback(computed(() => start + length));
    const reached = main.time.peek() - (spans[0]?.start ?? 0);
    playback.range.value = { from: start, to: start + length };
    playback.isLooping.value = true;
    playback.seek(start + Math.min(length, Math.max(0, reached)));
    if (!matchMedia("(prefers-reduced-motion: reduce)").matches) playback.play();
    return playback;
  });
  return shared;
}

/** The same trial for as long as what it is made of is. */
function useTrials(sides: readonly [Side, Side], start: number): readonly [Trial, Trial] {
  const scene = useStudio().document.scene.value;
  const left = useMemo(() => trialOf(scene, sides[0], start), [scene, sides[0], start]);
  const right = useMemo(() => trialOf(scene, sides[1], start), [scene, sides[1], start]);
  return [left, right];
}

function reportOf({ planner }: PlannedTrial, { segment }: Trial) {
  const planning = planner.segments.value[segment];
  return planning?.kind === "ready" ? planning.plan.report : null;
}
