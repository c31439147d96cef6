import { useStudio } from "../studio";

const SPEEDS = [0.25, 0.5, 0.75, 1, 1.5, 2];

/** How fast the show plays. */
export function SpeedMenu() {
  const { playback } = useStudio();
  return (
    <select
      class="speed number"
      aria-label="Speed"
      value={String(playback.speed.value)}
      onChange={(event) => {
        playback.speed.value = Number(event.currentTarget.value);
      }}
    >
      {SPEEDS.map((speed) => (
        <option key={speed} value={String(speed)}>
          {speed}×
        </option>
      ))}
    </select>
  );
}
