import { useSignal, useSignalEffect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { mainTrack } from "../../document/scene";
import type { Metric } from "../../engine/api";
import { NumberBox } from "../controls/number-box";
import type { Quantity } from "../controls/quantity";
import { Row } from "../controls/row";
import { Segmented } from "../controls/segmented";
import { Slider } from "../controls/slider";
import { useStudio } from "../studio";
import type { Proposal, Seeking } from "./proposal";
import { FACTOR, SHARING, wholeQuantity } from "./quantities";

type Kind = Seeking["kind"];

const KINDS: readonly { readonly value: Kind; readonly label: string }[] = [
  { value: "bisect", label: "Halves" },
  { value: "parts", label: "Parts" },
  { value: "connected", label: "Ties" },
  { value: "alike", label: "Alike" },
];

const METRICS: readonly { readonly value: Metric; readonly label: string }[] = [
  { value: "euclidean", label: "Euclidean" },
  { value: "manhattan", label: "Manhattan" },
];

/** From few groups to many. */
const HOW_MANY: Quantity = { ...SHARING, min: -1 };

/** The one number of each way: what it is called, its bounds, where it starts. */
const AMOUNTS = {
  bisect: { label: "Levels", quantity: wholeQuantity(1, 6), first: 1 },
  parts: { label: "Parts", quantity: wholeQuantity(2, 40), first: 3 },
  connected: { label: "Ties from", quantity: FACTOR, first: 2 },
  alike: { label: "Fewer – more", quantity: HOW_MANY, first: 0 },
} as const;

/** Groups on trial: shown on the stage as they would be, taken over as one step, gone without a trace on Cancel. */
export function ProposalPreview({ proposal, onClose }: { proposal: Proposal; onClose(): void }) {
  const { document } = useStudio();
  const kind = useSignal<Kind>("parts");
  const amounts = useSignal<Readonly<Record<Kind, number>>>({
    bisect: AMOUNTS.bisect.first,
    parts: AMOUNTS.parts.first,
    connected: AMOUNTS.connected.first,
    alike: AMOUNTS.alike.first,
  });
  const metric = useSignal<Metric>("euclidean");

  useSignalEffect(() => {
    const [sought, amount] = [kind.value, amounts.value[kind.value]];
    proposal.show(sought === "alike" ? { kind: sought, amount, metric: metric.value } : { kind: sought, amount });
  });
  useSignalEffect(() => {
    // Somebody edits what is proposed: that takes it over.
    if (!document.isDragging.value) onClose();
  });
  useEffect(() => {
    function onKeyDown(event: KeyboardEvent): void {
      if (event.key !== "Escape" || event.defaultPrevented) return;
      // A dialog over it, such as Share, is closed first.
      if (event.target instanceof Element && event.target.closest("dialog")) return;
      event.preventDefault();
      proposal.cancel();
      onClose();
    }
    addEventListener("keydown", onKeyDown, true);
    return () => removeEventListener("keydown", onKeyDown, true);
  });
  // What is shown when the panel goes is kept, as with any control; after Accept or Cancel nothing is open.
  useEffect(() => proposal.accept, [proposal]);

  // Who keeps together shows on the way to another keyframe.
  const hasWay = mainTrack(document.scene.value).keyframes.length > 1;
  const { label, quantity } = AMOUNTS[kind.value];
  const value = amounts.value[kind.value];
  const set = (next: number) => {
    amounts.value = { ...amounts.peek(), [kind.peek()]: next };
  };
  return (
    <>
      <Row label="Into">
        <Segmented
          label="Way to group"
          value={kind.value}
          choices={hasWay ? KINDS : KINDS.filter((known) => known.value !== "alike")}
          onChoose={(chosen) => {
            kind.value = chosen;
          }}
        />
      </Row>
      <Row label={label}>
        <span class="quantity">
          <Slider
            label={label}
            value={value}
            quantity={quantity}
            onPreview={set}
            onCommit={() => {}}
            onCancel={() => {}}
          />
          <NumberBox label={label} value={value} quantity={quantity} onCommit={set} />
        </span>
      </Row>
      {kind.value === "alike" && (
        <Row label="Distances">
          <Segmented
            label="Metric"
            value={metric.value}
            choices={METRICS}
            onChoose={(chosen) => {
              metric.value = chosen;
            }}
          />
        </Row>
      )}
      <p class="inspector-text">{proposal.words.value}</p>
      <div class="inspector-buttons">
        <button
          type="button"
          class="button"
          onClick={() => {
            proposal.accept();
            onClose();
          }}
        >
          Accept
        </button>
        <button
          type="button"
          class="button"
          onClick={() => {
            proposal.cancel();
            onClose();
          }}
        >
          Cancel
        </button>
      </div>
    </>
  );
}
