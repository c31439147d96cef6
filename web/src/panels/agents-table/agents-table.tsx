import "./agents-table.css";
import { selectedAgents } from "../../document/queries";
import { useStudio } from "../studio";
import { AgentRow } from "./agent-row";
import type { Cell } from "./cell-moves";
import { COLUMNS } from "./columns";
import { HeadingRow } from "./heading-row";
import { drawnRows } from "./row-window";
import { TableFoot } from "./table-foot";
import { useTable } from "./use-table";

/** Everybody by group, with their places at the playhead: the stage, for those who do not see it. */
export function AgentsTable() {
  const { document } = useStudio();
  const table = useTable();
  const { scroller, rows, offsets, scroll, active, editing, places } = table;
  const scene = document.scene.value;
  const selection = document.selection.value;
  const selected = selectedAgents(scene, selection);
  const shownRows = drawnRows(offsets.value, scroll.value.top, scroll.value.height, active.value.row);
  return (
    <>
      <div
        ref={scroller}
        class="agents-scroll"
        onScroll={(event) => {
          scroll.value = { ...scroll.peek(), top: event.currentTarget.scrollTop };
        }}
      >
        <table
          class="agents-table number"
          // biome-ignore lint/a11y/noNoninteractiveElementToInteractiveRole: a table whose cells take the focus is a grid
          role="grid"
          aria-label="Agents"
          aria-multiselectable="true"
          aria-rowcount={rows.value.length + 1}
          onKeyDown={table.onKeyDown}
          onPointerDown={(event) => {
            const cell = cellOf(event);
            if (!cell || event.button !== 0 || (editing.peek() && cell.row === active.peek().row)) return;
            const picking = event.shiftKey ? "range" : event.ctrlKey || event.metaKey ? "toggle" : "only";
            table.activate(cell);
            table.pickRow(cell.row, picking);
          }}
          onDblClick={(event) => {
            const cell = cellOf(event);
            if (cell) table.edit(cell, null);
          }}
          onFocusCapture={(event) => {
            const cell = cellOf(event);
            if (cell && event.target instanceof HTMLTableCellElement) table.activate(cell);
          }}
        >
          <thead>
            <tr aria-rowindex={1}>
              <th scope="col" class="cell-name">
                Name
              </th>
              <th scope="col">Group</th>
              <th scope="col" class="cell-x">
                x, {scene.stage.units}
              </th>
              <th scope="col" class="cell-y">
                y, {scene.stage.units}
              </th>
            </tr>
          </thead>
          <tbody>
            {shownRows.map((item, place) => {
              if (item.kind === "gap") {
                return (
                  // biome-ignore lint/a11y/noAriaHiddenOnFocusable: room for rows out of sight; nothing in it takes the focus
                  <tr key={place === 0 ? "above" : `gap ${place}`} class="gap-row" aria-hidden="true">
                    <td colSpan={COLUMNS.length} style={{ height: `${item.height}px` }} />
                  </tr>
                );
              }
              const row = rows.value[item.index];
              if (!row) return null;
              const isActive = active.value.row === item.index;
              if (row.kind === "heading") {
                const isSelected = selection.kind === "group" && selection.path.join() === row.path?.join();
                return (
                  <HeadingRow
                    key={`g${item.index}`}
                    index={item.index}
                    row={row}
                    isSelected={isSelected}
                    isStop={isActive}
                  />
                );
              }
              return (
                <AgentRow
                  key={row.agent}
                  index={item.index}
                  agent={row.agent}
                  path={row.path}
                  isSelected={selected.has(row.agent)}
                  stop={isActive ? active.value.column : null}
                  editing={isActive ? editing.value : null}
                  places={places}
                  onEnd={table.finish}
                />
              );
            })}
          </tbody>
        </table>
      </div>
      <TableFoot keyframe={table.keyframe} />
    </>
  );
}

function cellOf(event: Event): Cell | null {
  const found = event.target instanceof Element ? event.target.closest<HTMLElement>("[data-cell]") : null;
  const row = found?.closest<HTMLElement>("[data-row]")?.dataset.row;
  return found && row !== undefined ? { row: Number(row), column: Number(found.dataset.column) } : null;
}
