import { useRef } from "preact/hooks";
import { membershipOf, memberships } from "../../document/commands/membership";
import { useStudio } from "../studio";
import type { EditEnd } from "./cell-editor";

/** The groups an agent can be in, in its cell; gives back the key of the chosen one. */
export function GroupEditor(props: { label: string; agent: number; onEnd(key: string | null, end: EditEnd): void }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const isOver = useRef(false);
  function end(key: string | null, way: EditEnd): void {
    if (isOver.current) return;
    isOver.current = true;
    props.onEnd(key, way);
  }
  return (
    <select
      class="cell-editor"
      ref={(select) => {
        if (select && select.ownerDocument.activeElement !== select) select.focus();
      }}
      aria-label={props.label}
      value={membershipOf(scene, props.agent)}
      onChange={(event) => end(event.currentTarget.value, "stay")}
      onBlur={() => end(null, "leave")}
      onPointerDown={(event) => event.stopPropagation()}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key === "Escape") end(null, "stay");
        if (event.key === "Enter") end(event.currentTarget.value, "stay");
      }}
    >
      {memberships(scene).map(({ key, label }) => (
        <option key={key} value={key}>
          {label}
        </option>
      ))}
    </select>
  );
}
