export type TourPicture = "draw" | "next" | "ties" | "play";

/** A step of the tour: a small picture in ink, from faint to firm, and its words. */
export function TourStep({ picture, title, text }: { picture: TourPicture; title: string; text: string }) {
  return (
    <li class="tour-step">
      <svg viewBox="0 0 120 64" aria-hidden="true">
        <Picture picture={picture} />
      </svg>
      <h3>{title}</h3>
      <p>{text}</p>
    </li>
  );
}

const WAVE: readonly (readonly [x: number, y: number])[] = [
  [18, 26],
  [32, 19],
  [46, 19],
  [60, 27],
  [74, 39],
  [88, 45],
  [102, 40],
];

const TRIANGLE: readonly (readonly [x: number, y: number])[] = [
  [40, 46],
  [46, 34],
  [53, 22],
  [60, 10],
  [67, 22],
  [74, 34],
  [80, 46],
];

function Picture({ picture }: { picture: TourPicture }) {
  switch (picture) {
    case "draw":
      return (
        <>
          <path class="tour-line" d="M18 26C30 14 44 14 60 27S88 50 102 40" />
          {WAVE.map(([x, y], index) => (
            <circle key={x} cx={x} cy={y} r="4" opacity={0.25 + 0.125 * index} />
          ))}
        </>
      );
    case "next":
      return (
        <>
          {WAVE.map(([x, y]) => (
            <circle key={x} cx={x} cy={y + 6} r="3.5" opacity="0.22" />
          ))}
          {TRIANGLE.map(([x, y]) => (
            <circle key={x} class="tour-ring" cx={x} cy={y + 4} r="3.5" />
          ))}
        </>
      );
    case "ties":
      return (
        <>
          <path class="tour-tie" d="M40 20 56 34 40 48ZM56 34 76 26 88 42 72 50Z" />
          {[
            [40, 20],
            [56, 34],
            [40, 48],
            [76, 26],
            [88, 42],
            [72, 50],
          ].map(([x, y]) => (
            <circle key={`${x},${y}`} cx={x} cy={y} r="4" />
          ))}
        </>
      );
    case "play":
      return (
        <>
          <path class="tour-faint" d="M14 31 106 24V40L14 33Z" />
          <path d="M14 31 66 27V37L14 33Z" />
          <path class="tour-playhead" d="M66 12V52" />
        </>
      );
  }
}
