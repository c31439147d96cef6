import { type ReadonlySignal, type Signal, useComputed, useSignal } from "@preact/signals";
import type { RefObject } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { memberships, moveToGroup } from "../../document/commands/membership";
import { selectedAgents } from "../../document/queries";
import type { Command } from "../../document/store";
import { standingAt } from "../../document/timing";
import { useAtPlayhead } from "../at-playhead";
import { useStudio } from "../studio";
import type { Editing } from "./agent-row";
import type { EditEnd } from "./cell-editor";
import { type Cell, movedCell } from "./cell-moves";
import { COLUMNS, type ColumnName, cellCommand } from "./columns";
import { useLivePlaces } from "./live-places";
import { type Picking, pick } from "./picking";
import { type RowHeights, rowOffsets, scrollTo } from "./row-window";
import { type TableRow, tableRows } from "./table-rows";

const FINE: RowHeights = { heading: 32, agent: 27 };
const COARSE: RowHeights = { heading: 44, agent: 44 };
/** The head of the table stays above the rows, CSS pixels. */
const HEAD_HEIGHT = 28;

/** Rows and columns that the ways out of an edit lead on by. */
const STEPS: Readonly<Record<Exclude<EditEnd, "leave">, Cell>> = {
  stay: { row: 0, column: 0 },
  down: { row: 1, column: 0 },
  right: { row: 0, column: 1 },
  left: { row: 0, column: -1 },
};

/** The table at work: what it shows, which cell is in hand, and what keys and edits do to it. */
export interface TableAtWork {
  readonly scroller: RefObject<HTMLDivElement>;
  readonly rows: ReadonlySignal<readonly TableRow[]>;
  /** Where each row begins, CSS pixels. */
  readonly offsets: ReadonlySignal<Float64Array>;
  readonly scroll: Signal<{ readonly top: number; readonly height: number }>;
  /** The cell that Tab leads to. */
  readonly active: ReadonlySignal<Cell>;
  readonly editing: Signal<Editing | null>;
  readonly places: ReadonlySignal<ArrayLike<number>>;
  /** The keyframe the show stands in, whose places can be typed; null while it moves. */
  readonly keyframe: ReadonlySignal<number | null>;
  activate(cell: Cell): void;
  pickRow(row: number, picking: Picking): void;
  edit(cell: Cell, start: string | null): void;
  finish(text: string | null, end: EditEnd): void;
  onKeyDown(event: KeyboardEvent): void;
}

export function useTable(): TableAtWork {
  const { document, playback } = useStudio();
  const scroller = useRef<HTMLDivElement>(null);
  const scroll = useSignal({ top: 0, height: 600 });
  const wanted = useSignal<Cell>({ row: 0, column: 0 });
  const anchor = useSignal(0);
  const editing = useSignal<Editing | null>(null);
  const places = useLivePlaces();
  const rows = useComputed(() => tableRows(document.scene.value));
  const active = useComputed(() => ({ ...wanted.value, row: Math.min(wanted.value.row, rows.value.length - 1) }));
  const offsets = useComputed(() => rowOffsets(rows.value, matchMedia("(pointer: coarse)").matches ? COARSE : FINE));
  const standing = useAtPlayhead((time) => standingAt(document.scene.value, time));
  const keyframe = useComputed(() => (playback.isPlaying.value ? null : standing.value));
  const isOwnPick = useRef(false);
  const selection = document.selection.value;
  const selectedNow = () => selectedAgents(document.scene.peek(), document.selection.peek());

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
    const selected = selectedNow();
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
    wanted.value = cell;
    reveal(cell.row);
    const isHeading = rows.peek()[cell.row]?.kind === "heading";
    const name = `${cell.row}-${isHeading ? 0 : cell.column}`;
    // The row may first have to be drawn; whoever types by then keeps the focus.
    requestAnimationFrame(() => {
      if (!editing.peek()) scroller.current?.querySelector<HTMLElement>(`[data-cell="${name}"]`)?.focus();
    });
  }

  function pickRow(row: number, picking: Picking): void {
    isOwnPick.current = true;
    document.selection.value = pick(rows.peek(), selectedNow(), row, anchor.peek(), picking);
    if (picking !== "range") anchor.value = row;
  }

  function edit(cell: Cell, start: string | null): void {
    const column = COLUMNS[cell.column];
    if (!column || rows.peek()[cell.row]?.kind !== "agent") return;
    const isPlace = column === "x" || column === "y";
    const canEdit = isPlace ? keyframe.peek() !== null : column === "name" || document.scene.peek().groups.length > 0;
    if (canEdit) editing.value = { column, start };
  }

  function commandOf(agent: number, column: ColumnName, text: string): Command | null {
    const scene = document.scene.peek();
    const home = column === "group" ? memberships(scene).find((entry) => entry.key === text) : undefined;
    if (home) return moveToGroup(home.path, new Set([agent]));
    const standing = keyframe.peek();
    if (standing === null && column !== "name") return null;
    return cellCommand(scene, places.peek(), { agent, column, keyframe: standing ?? 0 }, text);
  }

  function finish(text: string | null, end: EditEnd): void {
    const cell = active.peek();
    const row = rows.peek()[cell.row];
    const column = editing.peek()?.column;
    editing.value = null;
    const command = text !== null && row?.kind === "agent" && column ? commandOf(row.agent, column, text) : null;
    if (command) document.perform(command);
    if (end === "leave") return;
    const step = STEPS[end];
    focusCell({
      row: Math.min(rows.peek().length - 1, cell.row + step.row),
      column: Math.max(0, Math.min(COLUMNS.length - 1, cell.column + step.column)),
    });
  }

  function onKeyDown(event: KeyboardEvent): void {
    const cell = active.peek();
    const isCtrl = event.ctrlKey || event.metaKey;
    const page = Math.max(1, Math.floor(scroll.peek().height / FINE.agent) - 1);
    const shape = { rowCount: rows.peek().length, columnCount: COLUMNS.length, page };
    const next = movedCell(cell, event.key, isCtrl, shape);
    const isTyping = event.key.length === 1 && !isCtrl && !event.altKey && COLUMNS[cell.column] !== "group";
    if (next) {
      focusCell(next);
      if (event.shiftKey && next.row !== cell.row) pickRow(next.row, "range");
    } else if (event.key === " ") pickRow(cell.row, "toggle");
    else if (event.key === "Enter" && rows.peek()[cell.row]?.kind === "heading") pickRow(cell.row, "only");
    else if (event.key === "Enter" || event.key === "F2") edit(cell, null);
    else if (isTyping) edit(cell, event.key);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  function activate(cell: Cell): void {
    wanted.value = cell;
  }

  const shown = { scroller, rows, offsets, scroll, active, editing, places, keyframe };
  return { ...shown, activate, pickRow, edit, finish, onKeyDown };
}
