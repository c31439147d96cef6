import type { ComponentChildren } from "preact";

/** The first of many; a single one more is not hidden. */
export function fewOf<Item>(all: readonly Item[], most: number): readonly Item[] {
  return all.length === most + 1 ? all : all.slice(0, most);
}

/** The first of many, one below the other, and how many more there are. */
export function Few<Item>(props: { all: readonly Item[]; most: number; children: (item: Item) => ComponentChildren }) {
  const few = fewOf(props.all, props.most);
  return (
    <>
      {few.map(props.children)}
      <AndMore count={props.all.length - few.length} />
    </>
  );
}

/** What a list leaves out; nothing when that is nobody. */
export function AndMore({ count }: { count: number }) {
  return count > 0 ? <p>and {count} more</p> : null;
}
