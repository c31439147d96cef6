import { Row } from "../controls/row";

/** A line of text that is taken over as it is typed. */
export function TextField(props: {
  label: string;
  value: string;
  placeholder?: string;
  limit: number;
  onInput(text: string): void;
}) {
  return (
    <Row label={props.label}>
      <input
        class="text-box"
        aria-label={props.label}
        placeholder={props.placeholder}
        maxLength={props.limit}
        autocomplete="off"
        spellcheck={false}
        value={props.value}
        onInput={(event) => props.onInput(event.currentTarget.value)}
      />
    </Row>
  );
}
