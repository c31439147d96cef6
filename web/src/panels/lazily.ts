import { signal } from "@preact/signals";
import { type ComponentType, type FunctionComponent, h } from "preact";
import { useEffect } from "preact/hooks";
import { NOT_LOADED } from "./messages";
import { type Studio, useStudio } from "./studio";

/** That a part did not come. */
export function sayNotLoaded({ messages }: Studio): void {
  messages.say(NOT_LOADED);
}

/** A component that is fetched when it is first shown, and shows nothing until then; `onFailed` when it does not come. */
export function lazily<Props extends object>(
  load: () => Promise<ComponentType<Props>>,
  onFailed: (studio: Studio, props: Props) => void = sayNotLoaded,
): FunctionComponent<Props> {
  const part = createPart(load);
  return function Lazy(props: Props) {
    const studio = useStudio();
    useEffect(() => part.fetch(() => onFailed(studio, props)), [studio]);
    const Shown = part.loaded.value?.component;
    return Shown ? h(Shown, props) : null;
  };
}

/** One fetch for all who show it; a failed one is tried again the next time it is shown, or when the connection is back. */
function createPart<Props extends object>(load: () => Promise<ComponentType<Props>>) {
  const loaded = signal<{ readonly component: ComponentType<Props> } | null>(null);
  let isFetching = false;
  function fetch(onFailed: () => void): void {
    if (isFetching || loaded.peek()) return;
    isFetching = true;
    load()
      .then((component) => {
        loaded.value = { component };
      })
      .catch(() => {
        addEventListener("online", () => fetch(onFailed), { once: true });
        onFailed();
      })
      .finally(() => {
        isFetching = false;
      });
  }
  return { loaded, fetch };
}
