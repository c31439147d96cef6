import "./hint.css";
import { useComputed, useSignal, useSignalEffect } from "@preact/signals";
import { useStudio } from "../studio";
import { HINT_STEPS, type HintStep, hintStep } from "./hint-step";

/** Where this browser remembers that the person knows. */
const KNOWN = "eigenform.hints-known";

const WORDS: Readonly<Record<HintStep, { readonly what: string; readonly how: string }>> = {
  draw: { what: "Start with Draw.", how: "Press and pull a line across the stage." },
  next: { what: "Now the next formation.", how: "Add a keyframe, then draw where they go." },
  play: { what: "See them move.", how: "Press Play." },
};

/** Three words of help to whoever starts on an empty stage, each at the control it speaks of; never in the way. */
export function Hint() {
  const { document, playback, toolbox, messages } = useStudio();
  const isKnown = useSignal(isKnownHere());
  const step = useComputed(() => hintStep(document.scene.value));

  useSignalEffect(() => {
    if (playback.isPlaying.value && step.peek() === "play") know();
  });
  function know(): void {
    isKnown.value = true;
    remember();
  }

  const shown = step.value;
  // The tool's own options take the place beside it.
  const isBesideOptions = shown === "draw" && (toolbox.active.value === "draw" || toolbox.active.value === "shape");
  // It would lie over what went wrong, which is worth more.
  const isInTheWay = messages.shown.value.some(({ tone }) => tone !== "good");
  if (isKnown.value || isBesideOptions || isInTheWay) return null;
  const { what, how } = WORDS[shown];
  return (
    <div class="hint" data-step={shown} role="note">
      <p>
        <strong>{what}</strong> {how}
      </p>
      <p class="hint-foot">
        <span class="number">{`${HINT_STEPS.indexOf(shown) + 1} of ${HINT_STEPS.length}`}</span>
        <button type="button" onClick={know}>
          Got it
        </button>
      </p>
    </div>
  );
}

// Storage may be blocked; then the hint is shown again another day.
function isKnownHere(): boolean {
  try {
    return localStorage.getItem(KNOWN) !== null;
  } catch {
    return false;
  }
}

function remember(): void {
  try {
    localStorage.setItem(KNOWN, "yes");
  } catch {
    return;
  }
}
