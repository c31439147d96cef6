import type { MeasureRow } from "./measure-rows";

/** Parts of the measure above them. */
const PARTS: ReadonlySet<string> = new Set(["at most", "before avoiding"]);

/** A column of numbers a way; the better one has the weight. */
export function MeasureTable({ names, rows }: { names: readonly string[]; rows: readonly MeasureRow[] }) {
  return (
    <table class="compare-table number">
      <caption class="unseen">Measures of {names.length > 2 ? "all" : "both"} ways</caption>
      <thead>
        <tr>
          <th scope="col">Measure</th>
          {names.map((name) => (
            <th key={name} scope="col">
              {name}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map((row, index) => (
          <tr key={index} class={PARTS.has(row.label) ? "compare-part" : undefined}>
            <th scope="row">{row.label}</th>
            {row.values.map((text, way) => (
              <Value key={way} text={text} isBetter={row.best === way} />
            ))}
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
