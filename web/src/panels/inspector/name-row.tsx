import { LIMITS } from "../../document/limits";
import { Row } from "../controls/row";
import { TextBox } from "../controls/text-box";

/** What something is called; `label` is what it reads as while it has no name. Its key is what it names. */
export function NameRow(props: { name: string; label: string; onCommit(name: string): void }) {
  return (
    <Row label="Name">
      <TextBox
        label="Name"
        value={props.name}
        placeholder={props.label}
        maxLength={LIMITS.name}
        onCommit={props.onCommit}
      />
    </Row>
  );
}
