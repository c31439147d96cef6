import "./assignment.css";
import { useSignal } from "@preact/signals";
import { X } from "lucide";
import { agentLabel } from "../../document/queries";
import { mainTrack, type Scene } from "../../document/scene";
import { Icon } from "../../theme/icons";
import { NumberBox } from "../controls/number-box";
import { Row } from "../controls/row";
import { fewOf } from "../few";
import { wholeQuantity } from "../inspector/quantities";
import type { AssignmentTrial } from "./create-trial";

/** More would push the answer out of sight. */
const MOST_SHOWN = 6;

/** The pairs that are given, each to be let go, and two numbers for whoever does not drag. */
export function LockList({ scene, trial }: { scene: Scene; trial: AssignmentTrial }) {
  const { locks } = trial.question.value.recipe;
  const pair = useSignal<readonly [agent: number, slot: number]>([1, 1]);
  /** A number that was to be locked and is nobody's. */
  const nobody = useSignal<number | null>(null);
  const count = mainTrack(scene).agents.length;
  const number = wholeQuantity(1, Math.max(1, count));
  const [agent, slot] = pair.value;
  const latest = fewOf(locks.toReversed(), MOST_SHOWN).toReversed();
  const gaveWay = trial.gaveWay.value;
  function lock(): void {
    nobody.value = pair.value.find((asked) => asked < 1 || asked > count) ?? null;
    if (nobody.value === null) trial.lock(agent - 1, slot - 1);
  }
  const hiddenCount = locks.length - latest.length;
  return (
    <>
      {locks.length > 0 && (
        <ul class="lock-list" aria-label="Locks">
          {latest.map(([locked, place]) => (
            <li key={locked}>
              <span class="ellipsis">
                {agentLabel(scene, locked)} → place of {agentLabel(scene, place)}
              </span>
              <button
                type="button"
                class="icon-button"
                aria-label={`Unlock ${agentLabel(scene, locked)}`}
                onClick={() => trial.unlock(locked)}
              >
                <Icon node={X} size={14} />
              </button>
            </li>
          ))}
        </ul>
      )}
      {hiddenCount > 0 && <p class="inspector-text">and {hiddenCount} more locks</p>}
      <p class="inspector-text" role="status">
        {nobody.value !== null && `Nobody is locked: there is no agent ${nobody.value}.`}
        {nobody.value === null &&
          gaveWay &&
          `${agentLabel(scene, gaveWay.agent)}'s lock gave way: ${agentLabel(scene, gaveWay.to)} has that place now.`}
      </p>
      <Row label="Lock" note="or drag on the stage">
        <span class="lock-pair">
          <NumberBox
            label="Agent to lock"
            value={agent}
            quantity={number}
            isLive
            isUnbound
            onCommit={(value) => {
              nobody.value = null;
              pair.value = [Math.round(value), slot];
            }}
          />
          <NumberBox
            label="Place of agent"
            prefix="to"
            value={slot}
            quantity={number}
            isLive
            isUnbound
            onCommit={(value) => {
              nobody.value = null;
              pair.value = [agent, Math.round(value)];
            }}
          />
          <button type="button" class="button" onClick={lock}>
            Lock
          </button>
        </span>
      </Row>
    </>
  );
}
