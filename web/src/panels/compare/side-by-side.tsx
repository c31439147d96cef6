import { computed, effect, signal } from "@preact/signals";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import type { Cost } from "../../document/scene";
import type { SegmentReport } from "../../engine/api";
import { createPlayback, type Playback } from "../../playback/playback";
import { fitting, type Padding } from "../../stage/camera";
import { createView } from "../../stage/create-view";
import { contentOf } from "../../stage/sheet";
import type { View } from "../../stage/view";
import { Select } from "../controls/select";
import { Switch } from "../controls/switch";
import { useStudio } from "../studio";
import { CompareTransport } from "./compare-transport";
import { measureRows } from "./measure-rows";
import { MeasureTable } from "./measure-table";
import { type Preset, presetsFor, sidesOf } from "./presets";
import { createSeater, type Seating } from "./seating";
import { SideColumn } from "./side-column";
import { tieChoices } from "./side-ties";
import { changed, commonStart, type Side, type SideChange, spanOf, takeOver, trialOf } from "./sides";

const OWN_CHOICE = "own";

/** CSS pixels about what is fitted: room for discs, hulls and ways that go around. */
const EDGES: Padding = { left: 40, right: 40, top: 40, bottom: 40 };

const PAIR = ["Left", "Right"];
const SEVERAL = ["First", "Second", "Third", "Fourth"];

export interface SidesProps {
  readonly first: readonly Side[];
  /** The known comparison to begin with. */
  readonly preset: string | undefined;
  onDone(): void;
}

/** All ways with one camera, one playhead, and a table of their numbers. */
export function Sides({ first, preset: begun, onDone }: SidesProps) {
  const { document, engine, messages } = useStudio();
  const scene = document.scene.value;
  const [sides, setSides] = useState(first);
  const [preset, setPreset] = useState(OWN_CHOICE);
  /** The one chosen last: places of an earlier one come too late. */
  const latest = useRef<Preset | null>(null);
  const seat = useMemo(() => createSeater(engine.findPlaces), [engine]);
  const presets = useMemo(() => presetsFor(scene), [scene]);
  const ties = useMemo(() => tieChoices(scene), [scene]);
  const isPair = sides.length === PAIR.length;
  const names = isPair ? PAIR : SEVERAL.slice(0, sides.length);
  const reports = useMemo(() => names.map(() => signal<SegmentReport | null>(null)), [names.length]);
  const start = commonStart(
    scene,
    first.map(({ segment }) => segment),
  );
  const playback = useSharedPlayback(first, start);
  const view = useSharedView(first[0], start);
  // One stage drives the time, the others follow.
  const following = useMemo((): Playback => ({ ...playback, tick() {} }), [playback]);
  const isAvoiding = sides.every(({ spec }) => spec.avoidance);

  function change(which: (index: number) => boolean, by: SideChange): void {
    setPreset(OWN_CHOICE);
    setSides((now) => now.map((side, index) => (which(index) ? changed(side, by) : side)));
  }

  async function choose(id: string): Promise<void> {
    setPreset(id);
    const chosen = presets.find((candidate) => candidate.id === id);
    if (!chosen) return;
    latest.current = chosen;
    const next = sidesOf(chosen, first);
    const costs = chosen.ways.map(({ cost }) => cost ?? "keep");
    const seatings = await Promise.all(next.map((side, index) => seated(side, costs[index] ?? "keep")));
    if (latest.current === chosen) setSides(next.map((side, index) => ({ ...side, seating: seatings[index] ?? null })));
  }

  /** As they are where none are found; why, is said. */
  async function seated({ segment }: Side, cost: Cost): Promise<Seating | null> {
    try {
      return await seat(scene, segment, cost);
    } catch (error) {
      const text = error instanceof Error ? error.message : String(error);
      messages.say({ tone: "problem", title: "No places were found.", text });
      return null;
    }
  }

  async function seatOne(side: Side, index: number, cost: Cost): Promise<void> {
    const seating = await seated(side, cost);
    setPreset(OWN_CHOICE);
    setSides((now) => now.map((other, at) => (at === index ? { ...other, seating } : other)));
  }

  useEffect(() => {
    if (begun) void choose(begun);
  }, []);

  function use(side: Side, name: string): void {
    document.perform(takeOver(side));
    messages.announce(`The transition goes the ${name.toLowerCase()} way now.`);
    onDone();
  }

  return (
    <div class={isPair ? "compare" : "compare is-many"}>
      <div class="compare-sides" style={{ "--across": sides.length > 3 ? 2 : sides.length }}>
        {sides.map((side, index) => {
          const [name, report] = [names[index], reports[index]];
          if (name === undefined || !report) return null;
          return (
            <SideColumn
              key={`${index} ${side.counterpart}`}
              name={name}
              side={side}
              start={start}
              ties={ties}
              playback={index === 0 ? playback : following}
              view={view}
              report={report}
              onChange={(by) => change((other) => other === index, by)}
              onSeat={(cost) => seatOne(side, index, cost)}
              onUse={() => use(side, name)}
            />
          );
        })}
      </div>
      <div class="compare-numbers">
        <Select
          label="What to compare"
          value={preset}
          choices={[
            { value: OWN_CHOICE, label: "Ways of your own" },
            ...presets.map(({ id, label }) => ({ value: id, label })),
          ]}
          onChoose={(id) => void choose(id)}
        />
        <Switch
          label="Avoid collisions"
          note={isPair ? "on both sides" : "in all of them"}
          isOn={isAvoiding}
          onToggle={(avoidance) => change(() => true, { options: { avoidance } })}
        />
        <MeasureTable
          names={names}
          rows={measureRows(
            reports.map((report) => report.value),
            scene.stage.units,
          )}
        />
        <p class="inspector-text">The better value has the weight. Less is better, except of clearance.</p>
      </div>
      <CompareTransport playback={playback} />
    </div>
  );
}

/** All stages have one size, so that one camera serves them all; theme and layers are the page's. */
function useSharedView(side: Side | undefined, start: number): View {
  const { document, view: main } = useStudio();
  const [shared] = useState(() => {
    const scene = document.scene.peek();
    const trial = signal(side ? trialOf(scene, side, start).scene : scene);
    return { scene: trial, view: { ...createView(trial), layers: main.layers, theme: main.theme } };
  });
  // The formations fill the stages, which have no tools to keep clear of.
  useEffect(
    () =>
      effect(() => {
        const size = shared.view.size.value;
        const content = contentOf(shared.scene.peek());
        if (content && size.width > 0) shared.view.camera.value = fitting(content, size, EDGES);
      }),
    [shared],
  );
  return shared.view;
}

/** A playhead over the longest way, in a loop; it begins to play where that is welcome. */
function useSharedPlayback(sides: readonly Side[], start: number): Playback {
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
