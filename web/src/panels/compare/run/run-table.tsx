import type { Units } from "../../../document/scene";
import type { Outcome } from "./create-run";
import { LineSample } from "./line-sample";
import { bestRows, type Column, cellText } from "./run-columns";
import type { RunRow } from "./run-rows";

/** A row a way; in every column the better numbers have the weight. */
export function RunTable(props: {
  rows: readonly RunRow[];
  outcomes: readonly Outcome[];
  columns: readonly Column[];
  hasCosts: boolean;
  units: Units;
}) {
  const { rows, outcomes, columns, hasCosts } = props;
  const compared = outcomes.map((outcome) => (outcome.kind === "done" ? outcome.compared : null));
  const best = columns.map((column) => bestRows(column, compared));
  return (
    <div class="run-table">
      <table class="compare-table number">
        <caption class="unseen">Averages over time of all ways</caption>
        <thead>
          <tr>
            <th scope="col">Method</th>
            {hasCosts && (
              <th scope="col" class="run-cost">
                Who goes where
              </th>
            )}
            {columns.map(({ label, unit, meaning }) => (
              <th key={label} scope="col" title={meaning}>
                {label} <small>{unit}</small>
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map((row, index) => {
            const outcome = outcomes[index];
            return (
              <tr key={`${row.cost.cost} ${row.way.way}`}>
                <th scope="row">
                  <LineSample line={row.line} /> {row.way.label}
                </th>
                {hasCosts && <td class="run-cost">{row.cost.label}</td>}
                {outcome?.kind === "done" ? (
                  columns.map((column, place) => (
                    <td key={column.label} class={best[place]?.has(index) ? "better" : undefined}>
                      {cellText(column, outcome.compared)}
                      {best[place]?.has(index) && <span class="unseen">, better</span>}
                    </td>
                  ))
                ) : (
                  <td class="run-pending" colSpan={columns.length}>
                    {outcome?.kind === "failed" ? outcome.problem : "…"}
                  </td>
                )}
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}
