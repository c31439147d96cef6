import "./side-panel.css";
import { X } from "lucide";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { Icon } from "../theme/icons";
import type { Aside } from "./aside";
import { useStudio } from "./studio";

/** A region that takes the inspector's place until it is closed; on a phone a sheet. The focus comes with it and goes back. */
export function SidePanel(props: {
  name: string;
  title: ComponentChildren;
  /** What stays when it is closed; absent: nothing. */
  leaves?: Aside | null;
  children: ComponentChildren;
}) {
  const { aside } = useStudio();
  const leave = () => {
    aside.value = props.leaves ?? null;
  };
  const close = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    const before = document.activeElement;
    close.current?.focus({ focusVisible: false } as FocusOptions);
    const panel = close.current?.closest("section");
    return () => {
      // Whoever has gone on meanwhile is left where they are.
      if (!panel?.contains(document.activeElement)) return;
      if (before instanceof HTMLElement && before.isConnected) before.focus({ focusVisible: false } as FocusOptions);
    };
  }, []);
  return (
    <section
      class="side-panel"
      aria-label={props.name}
      onKeyDown={(event) => {
        if (event.key !== "Escape" || event.defaultPrevented) return;
        event.stopPropagation();
        leave();
      }}
    >
      <header class="inspector-head">
        <p class="inspector-kind">
          <span>{props.name}</span>
          <button
            ref={close}
            type="button"
            class="icon-button side-panel-close"
            aria-label={`Close ${props.name}`}
            onClick={leave}
          >
            <Icon node={X} />
          </button>
        </p>
        <h2>{props.title}</h2>
      </header>
      {props.children}
    </section>
  );
}
