import { type ReadonlySignal, useComputed } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { groupLabel } from "../../document/queries";
import { type GroupPath, mainTrack } from "../../document/scene";
import { useStudio } from "../studio";
import { CellEditor, type EditEnd } from "./cell-editor";
import { accepts, COLUMNS, type ColumnName, cellText } from "./columns";
import { GroupEditor } from "./group-editor";

/** The cell being edited: what it starts from, when that is not what it reads. */
export interface Editing {
  readonly column: ColumnName;
  readonly start: string | null;
}

/** One agent: name, group and where it is now. */
export function AgentRow(props: {
  index: number;
  agent: number;
  path: GroupPath | null;
  isSelected: boolean;
  /** The column that Tab leads to, in the row that it leads to. */
  stop: number | null;
  editing: Editing | null;
  places: ReadonlySignal<ArrayLike<number>>;
  onEnd(text: string | null, end: EditEnd): void;
}) {
  const { document, view } = useStudio();
  const { agent, path, editing, places } = props;
  const scene = document.scene.value;
  const isAbsent = mainTrack(scene).keyframes[document.activeKeyframe.value]?.absent.includes(agent) ?? false;
  return (
    <tr
      class={props.isSelected ? "agent-row selected" : "agent-row"}
      aria-rowindex={props.index + 2}
      aria-selected={props.isSelected}
      data-row={props.index}
      onPointerEnter={() => {
        view.hovered.value = agent;
      }}
      onPointerLeave={() => {
        if (view.hovered.peek() === agent) view.hovered.value = null;
      }}
    >
      {COLUMNS.map((column, place) => (
        <TableCell key={column} column={column} row={props.index} place={place} isStop={props.stop === place}>
          {editing?.column === column ? (
            editor(column, editing)
          ) : column === "name" ? (
            <>
              {cellText(scene, [], agent, column)}
              {isAbsent && <span class="absent-mark">absent</span>}
            </>
          ) : column === "group" ? (
            path && groupLabel(scene, path)
          ) : (
            <Coordinate agent={agent} column={column} places={places} />
          )}
        </TableCell>
      ))}
    </tr>
  );

  function editor(column: ColumnName, { start }: Editing) {
    const name = cellText(scene, [], agent, "name");
    if (column === "group") return <GroupEditor label={`Group of ${name}`} agent={agent} onEnd={props.onEnd} />;
    return (
      <CellEditor
        label={column === "name" ? `Name of ${name}` : `${column} of ${name}`}
        text={start ?? cellText(scene, places.peek(), agent, column)}
        isBegun={start !== null}
        isNumber={column !== "name"}
        accepts={(text) => accepts(scene, column, text)}
        onEnd={props.onEnd}
      />
    );
  }
}

function TableCell(props: {
  column: ColumnName;
  row: number;
  place: number;
  isStop: boolean;
  children: ComponentChildren;
}) {
  return (
    <td
      class={`cell-${props.column}`}
      data-cell={`${props.row}-${props.place}`}
      data-column={props.place}
      tabIndex={props.isStop ? 0 : -1}
    >
      {props.children}
    </td>
  );
}

/** Written straight into its text while the show runs: the row is not rendered again. */
function Coordinate(props: { agent: number; column: "x" | "y"; places: ReadonlySignal<ArrayLike<number>> }) {
  const { document } = useStudio();
  const text = useComputed(() => cellText(document.scene.value, props.places.value, props.agent, props.column));
  return <>{text}</>;
}
