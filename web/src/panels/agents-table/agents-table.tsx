import "./agents-table.css";
import { useComputed, useSignal } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import { memberships, moveToGroup } from "../../document/commands/membership";
import { selectedAgents } from "../../document/queries";
import { momentAt } from "../../document/timing";
import { useStudio } from "../studio";
import { AgentRow, type Editing } from "./agent-row";
import type { EditEnd } from "./cell-editor";
import { type Cell, movedCell } from "./cell-moves";
import { COLUMNS, cellCommand } from "./columns";
import { HeadingRow } from "./heading-row";
import { useLivePlaces } from "./live-places";
import { type Picking, pick } from "./picking";
import { drawnRows, type RowHeights, rowOffsets, scrollTo } from "./row-window";
import { TableFoot } from "./table-foot";
import { tableRows } from "./table-rows";

const FINE: RowHeights = { heading: 32, agent: 27 };
const COARSE: RowHeights = { heading: 44, agent: 44 };
/** The head of the table stays above the rows. */
const HEAD_HEIGHT = 28;

/** Everybody by group, with their places at the playhead: the stage, for those who do not see it. */
export function AgentsTable() {
  const { document, playback } = useStudio();
  const scroller = useRef<HTMLDivElement>(null);
  const scroll = useSignal({ top: 0, height: 600 });
  const active = useSignal<Cell>({ row: 0, column: 0 });
  const anchor = useSignal(0);
  const editing = useSignal<Editing | null>(null);
  const places = useLivePlaces();
  const rows = useComputed(() => tableRows(document.scene.value));
  const offsets = useComputed(() => rowOffsets(rows.value, matchMedia("(pointer: coarse)").matches ? COARSE : FINE));
  const moment = useComputed(() => {
    const now = momentAt(document.scene.value, playback.time.value);
    return now.kind === "standing" && !playback.isPlaying.value ? now.keyframe : null;
  });
  const scene = document.scene.value;
  const selection = document.selection.value;
  const selected = selectedAgents(scene, selection);
  const isOwnPick = useRef(false);

  useLayoutEffect(() => {
    const element = scroller.current;
    if (!element) return;
    const measure = () => {
      scroll.value = { top: element.scrollTop, height: element.clientHeight - HEAD_HEIGHT };
    };
    const observer = new ResizeObserver(measure);
    measure();
    observer.observe(element);
    return () => observer.disconnect();
  }, [scroll]);

  // What is selected on the stage comes into sight here.
  useLayoutEffect(() => {
    const isOwn = isOwnPick.current;
    isOwnPick.current = false;
    if (isOwn || selected.size === 0) return;
    const first = rows.peek().findIndex((row) => row.kind === "agent" && selected.has(row.agent));
    if (first >= 0) reveal(first);
  }, [selection]);

  function reveal(row: number): void {
    const { top, height } = scroll.peek();
    const next = scrollTo(offsets.peek(), row, top, height);
    if (scroller.current && next !== top) scroller.current.scrollTop = next;
  }

  function focusCell(cell: Cell): void {
    active.value = cell;
    reveal(cell.row);
    const isHeading = rows.peek()[cell.row]?.kind === "heading";
    requestAnimationFrame(() => {
      const name = `${cell.row}-${isHeading ? 0 : cell.column}`;
      scroller.current?.querySelector<HTMLElement>(`[data-cell="${name}"]`)?.focus();
    });
  }

  function pickRow(row: number, picking: Picking): void {
    isOwnPick.current = true;
    document.selection.value = pick(rows.peek(), selected, row, anchor.peek(), picking);
    if (picking !== "range") anchor.value = row;
  }

  function edit(cell: Cell, start: string | null): void {
    const column = COLUMNS[cell.column];
    const row = rows.peek()[cell.row];
    if (!column || row?.kind !== "agent") return;
    const isPlace = column === "x" || column === "y";
    const hasGroups = column !== "group" || scene.groups.length > 0;
    if (hasGroups && (!isPlace || moment.peek() !== null)) editing.value = { column, start };
  }

  function finish(text: string | null, end: EditEnd): void {
    const cell = active.peek();
    const row = rows.peek()[cell.row];
    const column = editing.peek()?.column;
    editing.value = null;
    if (text !== null && row?.kind === "agent" && column) {
      const home = column === "group" ? memberships(scene).find((entry) => entry.key === text) : undefined;
      const command = home
        ? moveToGroup(home.path, new Set([row.agent]))
        : cellCommand(scene, places.peek(), { agent: row.agent, column, keyframe: moment.peek() ?? 0 }, text);
      if (command) document.perform(command);
    }
    const [down, right] = end === "down" ? [1, 0] : end === "right" ? [0, 1] : end === "left" ? [0, -1] : [0, 0];
    focusCell({
      row: Math.min(rows.peek().length - 1, cell.row + down),
      column: Math.max(0, Math.min(COLUMNS.length - 1, cell.column + right)),
    });
  }

  function onKeyDown(event: KeyboardEvent): void {
    const cell = active.peek();
    const isCtrl = event.ctrlKey || event.metaKey;
    const page = Math.max(1, Math.floor(scroll.peek().height / FINE.agent) - 1);
    const next = movedCell(cell, event.key, isCtrl, {
      rowCount: rows.peek().length,
      columnCount: COLUMNS.length,
      page,
    });
    if (next) {
      focusCell(next);
      if (event.shiftKey && next.row !== cell.row) pickRow(next.row, "range");
    } else if (event.key === " ") pickRow(cell.row, "toggle");
    else if (event.key === "Enter" || event.key === "F2") {
      if (rows.peek()[cell.row]?.kind === "heading") pickRow(cell.row, "only");
      else edit(cell, null);
    } else if (event.key.length === 1 && !isCtrl && !event.altKey && COLUMNS[cell.column] !== "group")
      edit(cell, event.key);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  function cellOf(event: Event): Cell | null {
    const found = event.target instanceof Element ? event.target.closest<HTMLElement>("[data-cell]") : null;
    const row = found?.closest<HTMLElement>("[data-row]")?.dataset.row;
    return found && row !== undefined ? { row: Number(row), column: Number(found.dataset.column) } : null;
  }

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
          onKeyDown={onKeyDown}
          onPointerDown={(event) => {
            const cell = cellOf(event);
            if (!cell || event.button !== 0 || (editing.peek() && cell.row === active.peek().row)) return;
            const picking = event.shiftKey ? "range" : event.ctrlKey || event.metaKey ? "toggle" : "only";
            active.value = cell;
            pickRow(cell.row, picking);
          }}
          onDblClick={(event) => {
            const cell = cellOf(event);
            if (cell) edit(cell, null);
          }}
          onFocusCapture={(event) => {
            const cell = cellOf(event);
            if (cell && event.target instanceof HTMLTableCellElement) active.value = cell;
          }}
        >
          <thead>
            <tr aria-rowindex={1}>
              <th scope="col">Name</th>
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
                  onEnd={finish}
                />
              );
            })}
          </tbody>
        </table>
      </div>
      <TableFoot keyframe={moment} />
    </>
  );
}
