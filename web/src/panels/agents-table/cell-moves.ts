/** A cell of the table; a heading has only its first column. */
export interface Cell {
  readonly row: number;
  readonly column: number;
}

export interface TableShape {
  readonly rowCount: number;
  readonly columnCount: number;
  /** Rows in sight. */
  readonly page: number;
}

/** The cell a key leads to; null for keys that do not move. */
export function movedCell(cell: Cell, key: string, isCtrl: boolean, shape: TableShape): Cell | null {
  const lastRow = shape.rowCount - 1;
  const lastColumn = shape.columnCount - 1;
  const go = (row: number, column: number): Cell => ({
    row: Math.max(0, Math.min(lastRow, row)),
    column: Math.max(0, Math.min(lastColumn, column)),
  });
  switch (key) {
    case "ArrowUp":
      return go(cell.row - 1, cell.column);
    case "ArrowDown":
      return go(cell.row + 1, cell.column);
    case "ArrowLeft":
      return go(cell.row, cell.column - 1);
    case "ArrowRight":
      return go(cell.row, cell.column + 1);
    case "PageUp":
      return go(cell.row - shape.page, cell.column);
    case "PageDown":
      return go(cell.row + shape.page, cell.column);
    case "Home":
      return isCtrl ? go(0, 0) : go(cell.row, 0);
    case "End":
      return isCtrl ? go(lastRow, lastColumn) : go(cell.row, lastColumn);
    default:
      return null;
  }
}
