import { useState } from "preact/hooks";
import { mainTrack } from "../../document/scene";
import { formatAngle, formatLength, formatNumber } from "../../document/units";
import type { SegmentReport } from "../../engine/api";
import { status } from "../status";
import { useStudio } from "../studio";
import { allOfThem, bestOfEach, type CandidateRow } from "./candidate-rows";
import { Section } from "./section";
import { methodWord } from "./words";

/** Above this auto tries fewer. */
const MANY_AGENTS = 400;

interface CandidatesProps {
  readonly report: SegmentReport;
  readonly isAuto: boolean;
  /** Of a motion that another is planned in place of. */
  readonly isFormer: boolean;
}

/** The methods that were tried and what was measured of each: the table from which auto chose. */
export function Candidates({ report, isAuto, isFormer }: CandidatesProps) {
  const { document } = useStudio();
  const [isWhole, setWhole] = useState(false);
  const { candidates } = report;
  if (candidates.length === 0) return null;
  const rows = isWhole ? allOfThem(candidates) : bestOfEach(candidates);
  const title = isAuto ? `Why auto chose ${methodWord(report.choice.method)}` : "Methods compared";
  return (
    <Section title={title} note="at 17 instants; lower is better" isFormer={isFormer}>
      <table class="candidates number">
        <thead>
          <tr>
            <th scope="col">Method</th>
            <th scope="col">Distortion</th>
            <th scope="col">Turning</th>
            <th scope="col">Clearance</th>
            <th scope="col">Score</th>
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <CandidateLine key={`${row.name} ${row.detail}`} row={row} hasDetail={isWhole} />
          ))}
        </tbody>
      </table>
      {isAuto && mainTrack(document.scene.value).agents.length > MANY_AGENTS && (
        <p class="inspector-text candidates-note">
          With more than {MANY_AGENTS} agents auto tries these {candidates.length} only.
        </p>
      )}
      {rows.length < candidates.length || isWhole ? (
        <button
          type="button"
          class="button quiet more-candidates"
          aria-expanded={isWhole}
          onClick={() => setWhole(!isWhole)}
        >
          {isWhole ? "Best of each method" : `All ${candidates.length} that were tried`}
        </button>
      ) : null}
    </Section>
  );
}

function CandidateLine({ row, hasDetail }: { row: CandidateRow; hasDetail: boolean }) {
  const { document } = useStudio();
  const { minimumDistance, stage } = document.scene.value;
  const { candidate } = row;
  return (
    <tr class={candidate.isChosen ? "chosen" : undefined}>
      <th scope="row">
        {row.name}
        {candidate.isChosen && <span class="unseen">, chosen</span>}
        {hasDetail && row.detail && <small>{row.detail}</small>}
      </th>
      <td>{formatNumber(candidate.distortion)}</td>
      <td>{formatAngle(candidate.turning)}</td>
      <td class={status(candidate.clearance, minimumDistance)}>
        {candidate.clearance === null ? "" : formatLength(candidate.clearance, stage.units)}
      </td>
      <td>{formatNumber(candidate.score)}</td>
    </tr>
  );
}
