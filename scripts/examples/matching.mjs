/**
 * Which target each source takes so that the sum of squared distances is least: shortest augmenting paths.
 *
 * Squares make the answer the same wherever the group goes as a whole, so that a group keeps its arrangement.
 */
export function match(sources, targets) {
  const count = sources.length;
  const cost = (source, target) =>
    (sources[source][0] - targets[target][0]) ** 2 + (sources[source][1] - targets[target][1]) ** 2;
  const rowPrice = new Float64Array(count + 1);
  const columnPrice = new Float64Array(count + 1);
  const rowOf = new Int32Array(count + 1);
  const way = new Int32Array(count + 1);
  for (let row = 1; row <= count; row += 1) {
    rowOf[0] = row;
    let column = 0;
    const least = new Float64Array(count + 1).fill(Number.POSITIVE_INFINITY);
    const isUsed = new Uint8Array(count + 1);
    do {
      isUsed[column] = 1;
      const from = rowOf[column];
      let step = Number.POSITIVE_INFINITY;
      let next = 0;
      for (let to = 1; to <= count; to += 1) {
        if (isUsed[to]) continue;
        const reduced = cost(from - 1, to - 1) - rowPrice[from] - columnPrice[to];
        if (reduced < least[to]) {
          least[to] = reduced;
          way[to] = column;
        }
        if (least[to] < step) {
          step = least[to];
          next = to;
        }
      }
      for (let to = 0; to <= count; to += 1) {
        if (isUsed[to]) {
          rowPrice[rowOf[to]] += step;
          columnPrice[to] -= step;
        } else {
          least[to] -= step;
        }
      }
      column = next;
    } while (rowOf[column] !== 0);
    while (column !== 0) {
      rowOf[column] = rowOf[way[column]];
      column = way[column];
    }
  }
  const taken = new Array(count);
  for (let column = 1; column <= count; column += 1) taken[rowOf[column] - 1] = targets[column - 1];
  return taken;
}
