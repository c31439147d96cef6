import type { Frame } from "./frame";

/** Sprites exist for so many positions within a pixel in each direction: discs glide, yet are stamped pixel for pixel. */
const PHASES = 4;

/** Discs of every color, drawn once. */
export interface Sprites {
  /** Whether they are what `frame` needs. */
  fits(frame: Frame, halo: number): boolean;
  /** Every agent of the frame, in order. */
  stamp(context: CanvasRenderingContext2D, frame: Frame): void;
}

export function createSprites(frame: Frame, halo: number): Sprites {
  const { density, radius, cast, palette } = frame;
  const reach = Math.ceil((radius + halo) * density) + 1;
  const side = 2 * reach + 1;
  const sheet = document.createElement("canvas");
  sheet.width = side * PHASES * PHASES;
  sheet.height = side * Math.max(cast.paints.length, 1);
  const pen = sheet.getContext("2d");
  const rows = new Uint16Array(cast.colors.length);
  cast.paints.forEach(({ color, agents }, row) => {
    for (const agent of agents) rows[agent] = row;
    for (let phase = 0; pen && phase < PHASES * PHASES; phase += 1) {
      const x = phase * side + reach + ((phase % PHASES) + 0.5) / PHASES;
      const y = row * side + reach + (Math.floor(phase / PHASES) + 0.5) / PHASES;
      if (halo > 0) {
        pen.fillStyle = palette.sheet;
        pen.beginPath();
        pen.arc(x, y, (radius + halo) * density, 0, 2 * Math.PI);
        pen.fill();
      }
      pen.fillStyle = color;
      pen.beginPath();
      pen.arc(x, y, radius * density, 0, 2 * Math.PI);
      pen.fill();
    }
  });

  return {
    fits: (next, nextHalo) =>
      next.cast === cast && next.radius === radius && next.density === density && nextHalo === halo,
    stamp(context, { points, agentCount, size, isGone, presence }) {
      // In canvas pixels, so that every sprite lands on whole ones.
      context.save();
      context.setTransform(1, 0, 0, 1, 0, 0);
      const width = size.width * density;
      const height = size.height * density;
      for (let agent = 0; agent < agentCount; agent += 1) {
        const x = (points[2 * agent] ?? 0) * density;
        const y = (points[2 * agent + 1] ?? 0) * density;
        if (isGone?.[agent] || x < -reach || y < -reach || x > width + reach || y > height + reach) continue;
        const left = Math.floor(x);
        const top = Math.floor(y);
        const phase = Math.floor((y - top) * PHASES) * PHASES + Math.floor((x - left) * PHASES);
        const row = rows[agent] ?? 0;
        if (presence) context.globalAlpha = presence[agent] ?? 1;
        context.drawImage(sheet, phase * side, row * side, side, side, left - reach, top - reach, side, side);
      }
      context.restore();
    },
  };
}
