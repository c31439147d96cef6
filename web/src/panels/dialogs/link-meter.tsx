import { formatCount } from "../../document/units";
import { isPast, LINK_LIMITS, meterPlace } from "./share-words";

const WIDTH = 1000;
const HEIGHT = 16;
const THIN = 2;

/** The length of a link on a ribbon from faint to firm, with the places that would cut it. */
export function LinkMeter({ characters }: { characters: number }) {
  const place = meterPlace(characters);
  return (
    <div class="link-meter" aria-hidden="true">
      <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} preserveAspectRatio="none" aria-hidden="true">
        <path class="meter-rest" d={wedge(1)} />
        <path class="meter-used" d={wedge(place)} />
      </svg>
      <i ref={standAt(place)} class="meter-knob" />
      {LINK_LIMITS.map((limit) => (
        <span
          key={limit.name}
          ref={standAt(limit.characters === null ? 1 : meterPlace(limit.characters))}
          class={isPast(limit, characters) ? "meter-limit is-past" : "meter-limit"}
        >
          <b>{limit.name}</b>
          <small class="number">{limit.characters === null ? "any length" : formatCount(limit.characters)}</small>
        </span>
      ))}
    </div>
  );
}

/** The ribbon's first `share`, 0..1. */
function wedge(share: number): string {
  const half = (THIN + (HEIGHT - THIN) * share) / 2;
  const middle = HEIGHT / 2;
  const x = share * WIDTH;
  return `M0 ${middle - THIN / 2}L${x} ${middle - half}V${middle + half}L0 ${middle + THIN / 2}Z`;
}

function standAt(share: number): (element: HTMLElement | null) => void {
  return (element) => {
    if (element) element.style.left = `${share * 100}%`;
  };
}
