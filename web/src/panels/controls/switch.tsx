/** On or off, with its words in the left column. */
export function Switch(props: { label: string; note?: string; isOn: boolean; onToggle(isOn: boolean): void }) {
  return (
    <label class="row switch-row">
      <span class="row-label">
        {props.label}
        {props.note && <small>{props.note}</small>}
      </span>
      <input
        type="checkbox"
        class="switch"
        checked={props.isOn}
        onChange={(event) => props.onToggle(event.currentTarget.checked)}
      />
    </label>
  );
}
