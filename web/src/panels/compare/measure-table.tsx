import type { MeasureRow } from "./measure-rows";

/** Both columns of numbers; the better one has the weight. */
export function MeasureTable({ rows }: { rows: readonly MeasureRow[] }) {
  return (
    <table class="compare-table number">
      <caption class="unseen">Measures of both ways</caption>
      <thead>
        <tr>
          <th scope="col">Measure</th>
          <th scope="col">Left</th>
          <th scope="col">Right</th>
        </tr>
      </thead>
      <tbody>
        {rows.map((row, index) => (
          <tr key={index} class={row.label === "at most" ? "compare-most" : undefined}>
            <th scope="row">{row.label}</th>
            <Value text={row.left} isBetter={row.better === "left"} />
            <Value text={row.right} isBetter={row.better === "right"} />
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function Value({ text, isBetter }: { text: string | null; isBetter: boolean }) {
  return (
    <td class={isBetter ? "better" : undefined}>
      {text ?? "–"}
      {isBetter && <span class="unseen">, better</span>}
    </td>
  );
}
