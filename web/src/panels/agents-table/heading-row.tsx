import { formatCount } from "../../document/units";
import { AgentDot } from "../agent-dot";
import { COLUMNS } from "./columns";
import type { TableRow } from "./table-rows";

/** A group above its agents. */
export function HeadingRow(props: {
  index: number;
  row: Extract<TableRow, { kind: "heading" }>;
  isSelected: boolean;
  isStop: boolean;
}) {
  const { row, index } = props;
  return (
    <tr
      class={props.isSelected ? "heading-row selected" : "heading-row"}
      aria-rowindex={index + 2}
      aria-selected={props.isSelected}
      data-row={index}
    >
      <td colSpan={COLUMNS.length} data-cell={`${index}-0`} data-column="0" tabIndex={props.isStop ? 0 : -1}>
        <span class="heading">
          {row.color && <AgentDot color={row.color} />}
          <span class="ellipsis">{row.label}</span>
          <span class="number unit">{formatCount(row.agentCount)}</span>
          {row.tieWeight !== null && <span class="heading-ties number unit">ties ×{row.tieWeight}</span>}
        </span>
      </td>
    </tr>
  );
}
