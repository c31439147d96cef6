import type { Formation } from "../../document/formation";
import { formatCount, formatNumber, lengthWithUnit } from "../../document/units";
import type { ModeBasis } from "../../engine/modes";
import { Slider } from "../controls/slider";
import { wholeQuantity } from "../inspector/quantities";
import { Section } from "../inspector/section";
import { useStudio } from "../studio";
import { coefficientsOf, cutPairs, partialFormation, rmsError, sidesOf } from "./mode-geometry";
import { SpectrumPlot } from "./spectrum-plot";

interface ModeSectionProps {
  readonly basis: ModeBasis;
  readonly formation: Formation;
  readonly pairs: Uint32Array;
  /** The formation is put together from so many modes; the last of them is looked at. */
  readonly count: number;
  onCount(count: number): void;
}

/** One mode after another: how much it weighs, what it cuts, and what the formation looks like up to it. */
export function ModeSection({ basis, formation, pairs, count, onCount }: ModeSectionProps) {
  const { units } = useStudio().document.scene.value.stage;
  const quantity = wholeQuantity(1, basis.shownCount);
  const off = rmsError(partialFormation(basis, coefficientsOf(basis, formation), count), formation);
  const cut = cutPairs(pairs, sidesOf(basis.mode(count - 1))).length / 2;
  const ties = pairs.length / 2;
  return (
    <>
      <Section title="Eigenvalues" note={`mode ${count}: ${formatNumber(basis.eigenvalues[count - 1] ?? 0)}`}>
        <SpectrumPlot basis={basis} count={count} />
        <Slider
          label="Modes"
          value={count}
          quantity={quantity}
          onPreview={(value) => onCount(Math.round(value))}
          onCommit={() => {}}
          onCancel={() => {}}
        />
        <p class="slider-ends" aria-hidden="true">
          <span>large parts</span>
          <span>single agents</span>
        </p>
        <p class="inspector-text modes-caption">
          Each mode is a way of moving apart along the ties. A small eigenvalue moves large parts of the group, a large
          one tells neighbors apart.
        </p>
      </Section>
      <Section title={`Mode ${formatCount(count)} of ${formatCount(basis.agentCount)}`}>
        <dl class="modes-facts number">
          <dt>Cuts</dt>
          <dd>{cutWords(cut, ties)}</dd>
          <dt>Formation so far</dt>
          <dd>{off < 5e-4 ? "exact" : `${lengthWithUnit(off, units)} off`}</dd>
        </dl>
        <p class="inspector-text modes-caption">
          {count === 1
            ? "The first mode is the same for everybody: alone it puts the whole group on its middle."
            : "Filled agents go one way and hollow ones the other; heavy lines are the ties between them, which the mode cuts. Wedges show what it adds to the modes before it, pale discs how far the formation has come."}
        </p>
      </Section>
    </>
  );
}

/** `3 of 9 ties` */
export function cutWords(cut: number, ties: number): string {
  return `${formatCount(cut)} of ${formatCount(ties)} ${ties === 1 ? "tie" : "ties"}`;
}
