import "./run.css";
import { Copy } from "lucide";
import { useEffect, useMemo, useState } from "preact/hooks";
import { updateSegment } from "../../../document/edit";
import { mainTrack } from "../../../document/scene";
import { metersPer } from "../../../document/units";
import { askComparison, type Compared } from "../../../engine/comparison";
import { Icon } from "../../../theme/icons";
import { useStudio } from "../../studio";
import { useSolo } from "../../use-solo";
import { createRun, type Outcome, outcomeOf } from "./create-run";
import { type Curve, CurvePlot } from "./curve-plot";
import { LineSample } from "./line-sample";
import { RunChoices, type RunSetting } from "./run-choices";
import { columnsFor, tabSeparated } from "./run-columns";
import { type RunRow, rowsOf } from "./run-rows";
import { RunTable } from "./run-table";
import { RUN_PRESETS } from "./run-words";

/** Meters a second: the mean of pedestrians that the papers' forces are made for (Helbing and Molnár 1995). */
const WALKING_PACE = 1.34;

type CurveName = Exclude<keyof Compared["curves"], "times">;

/** The plots of paper D's figures 11 and 13, and how the target is neared. */
const PLOTS: readonly { readonly curve: CurveName; readonly title: string; readonly isLength: boolean }[] = [
  { curve: "mutualInformation", title: "Direction told by place, I_d", isLength: false },
  { curve: "structureDeviation", title: "Structure σ", isLength: true },
  { curve: "effortDeviation", title: "Effort σ", isLength: true },
  { curve: "targetDeviation", title: "To the target", isLength: true },
];

/** A transition in as many ways as a person asks for: their numbers as a table, and over time. */
export function RunView({ segment, preset }: { segment: number; preset: string | undefined }) {
  const { document, messages } = useStudio();
  const { units } = document.scene.value.stage;
  const { setting, change, rows, outcomes, isWorking, goOn, stop } = useRun(segment, preset);
  const columns = columnsFor(units).filter(
    (column) =>
      column.label !== "Missed by" ||
      outcomes.some((outcome) => outcome.kind === "done" && column.value(outcome.compared) !== null),
  );
  const hasCosts = setting.costs.length > 1 || setting.costs[0] !== "keep";
  const known = outcomes.filter(({ kind }) => kind !== "waiting").length;

  async function copy(): Promise<void> {
    const named = rows.map(({ way, cost }, index) => {
      const outcome = outcomes[index];
      return { way: way.label, cost: cost.label, compared: outcome?.kind === "done" ? outcome.compared : null };
    });
    try {
      await navigator.clipboard.writeText(tabSeparated(named, columns));
      messages.announce("Table copied");
    } catch {
      const title = "The browser keeps the clipboard to itself.";
      messages.say({ tone: "problem", title, text: "Select the table and use the keys instead." });
    }
  }

  return (
    <div class="run">
      <RunChoices setting={setting} units={units} onChange={change}>
        <div class="inspector-buttons">
          <button type="button" class="button" disabled={known === 0} onClick={() => void copy()}>
            <Icon node={Copy} size={14} /> Copy the table
          </button>
          {isWorking && (
            <button type="button" class="button" onClick={stop}>
              Stop
            </button>
          )}
          {!isWorking && known < rows.length && (
            <button type="button" class="button" onClick={goOn}>
              Go on
            </button>
          )}
        </div>
        <p class="inspector-text" role="status">
          {isWorking ? `${known} of ${rows.length} ways are there.` : ""}
        </p>
      </RunChoices>
      <div class="run-results">
        {rows.length === 0 ? (
          <p class="inspector-text">Choose at least one method, and who goes where.</p>
        ) : (
          <>
            <RunTable rows={rows} outcomes={outcomes} columns={columns} hasCosts={hasCosts} units={units} />
            <p class="inspector-text">
              Averages over time. The better value has the weight: less is better, except of clearance. A dash under
              Time: some never arrive by forces alone.
            </p>
            <Plots rows={rows} outcomes={outcomes} hasCosts={hasCosts} units={units} />
          </>
        )}
      </div>
    </div>
  );
}

function Plots(props: {
  rows: readonly RunRow[];
  outcomes: readonly Outcome[];
  hasCosts: boolean;
  units: Parameters<typeof metersPer>[0];
}) {
  const { rows, outcomes, hasCosts, units } = props;
  const plots = useMemo(
    () =>
      PLOTS.map(({ curve, title, isLength }) => ({
        title,
        unit: isLength ? units : "bits",
        curves: rows.flatMap((row, index) => curveOf(row, outcomes[index], curve, isLength ? metersPer(units) : 1)),
      })),
    [rows, outcomes, units],
  );
  return (
    <>
      <ul class="run-legend" aria-label="Legend">
        {rows.map(({ way, cost, line }) => (
          <li key={`${cost.cost} ${way.way}`}>
            <LineSample line={line} /> {hasCosts ? `${way.label} · ${cost.label}` : way.label}
          </li>
        ))}
      </ul>
      <div class="run-plots">
        {plots.map((plot) => (
          <CurvePlot key={plot.title} {...plot} />
        ))}
      </div>
    </>
  );
}

/** From the departure on. */
function curveOf({ way, line }: RunRow, outcome: Outcome | undefined, name: CurveName, per: number): Curve[] {
  if (outcome?.kind !== "done") return [];
  const { curves } = outcome.compared;
  const start = curves.times[0] ?? 0;
  const times = curves.times.map((time) => time - start);
  return [{ label: way.label, ...line, times, values: curves[name].map((value) => value / per) }];
}

/** What is asked for, and what is known of it: anew when the scene is another. */
function useRun(segment: number, preset: string | undefined) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const solo = useSolo();
  const [setting, setSetting] = useState<RunSetting>(() => {
    const begun = RUN_PRESETS.find(({ id }) => id === preset) ?? RUN_PRESETS[0];
    const { ways, costs, isFree } = begun ?? { ways: [], costs: [], isFree: false };
    return {
      ways,
      costs,
      isFree,
      pace: WALKING_PACE,
      isAvoiding: mainTrack(scene).segments[segment]?.avoidance ?? false,
    };
  });
  const { isAvoiding, isFree, pace } = setting;
  const tried = useMemo(
    () => updateSegment(scene, segment, (was) => ({ ...was, avoidance: isAvoiding })),
    [scene, segment, isAvoiding],
  );
  const run = useMemo(
    () =>
      createRun({
        ask: (question) => askComparison(solo, tried, question),
        cancel: () => void solo.ask("cancel", () => null).catch(() => {}),
      }),
    [solo, tried],
  );
  const rows = useMemo(() => rowsOf(setting), [setting]);
  const questions = useMemo(
    () => rows.map(({ way, cost }) => ({ segment, way: way.way, cost: cost.cost, pace: isFree ? pace : null })),
    [rows, segment, isFree, pace],
  );
  useEffect(() => run.want(questions), [run, questions]);
  useEffect(() => run.stop, [run]);
  const known = run.known.value;
  const outcomes = useMemo(() => questions.map((question) => outcomeOf(known, question)), [known, questions]);
  return {
    setting,
    change: (by: Partial<RunSetting>) => setSetting((was) => ({ ...was, ...by })),
    rows,
    outcomes,
    isWorking: run.isWorking.value,
    goOn: () => run.want(questions),
    stop: run.stop,
  };
}
