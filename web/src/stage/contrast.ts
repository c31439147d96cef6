/** Linear-light red, green, blue, 0..1. */
type Linear = readonly [r: number, g: number, b: number];

/** Relative luminance of `#rrggbb`, 0..1 (WCAG 2.2). */
function luminance(hex: string): number {
  const [r, g, b] = linearOf(hex);
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** Contrast ratio of two colors, 1..21 (WCAG 2.2). */
export function contrast(a: string, b: string): number {
  const [x, y] = [luminance(a), luminance(b)];
  return (Math.max(x, y) + 0.05) / (Math.min(x, y) + 0.05);
}

/**
 * `color` with its hue kept, moved away from `ground` in lightness just until their contrast reaches `ratio`.
 *
 * Lightness and hue are OKLab's (Ottosson 2020); chroma shrinks where the screen has no such color.
 */
export function withContrast(color: string, ground: string, ratio: number): string {
  if (contrast(color, ground) >= ratio) return color;
  const [lightness, a, b] = labOf(linearOf(color));
  const goal = luminance(ground) > 0.18 ? 0 : 1;
  // Halving the way 12 times ends within a quarter of an 8-bit step, on the side that has the contrast.
  let near = 0;
  let far = 1;
  for (let step = 0; step < 12; step += 1) {
    const middle = (near + far) / 2;
    const candidate = shownAt(lightness + (goal - lightness) * middle, a, b);
    if (contrast(candidate, ground) >= ratio) far = middle;
    else near = middle;
  }
  return shownAt(lightness + (goal - lightness) * far, a, b);
}

/** Black or white, whichever reads better on `color`. */
export function inkOn(color: string): "#101513" | "#ffffff" {
  return contrast(color, "#101513") >= contrast(color, "#ffffff") ? "#101513" : "#ffffff";
}

function shownAt(lightness: number, a: number, b: number): string {
  let chroma = 1;
  let linear = linearFromLab(lightness, a, b);
  while (chroma > 0 && linear.some((channel) => channel < -1e-4 || channel > 1 + 1e-4)) {
    chroma -= 1 / 32;
    linear = linearFromLab(lightness, a * chroma, b * chroma);
  }
  return hexOf(linear);
}

function linearOf(hex: string): Linear {
  const value = Number.parseInt(hex.slice(1), 16);
  return [decoded((value >> 16) / 255), decoded(((value >> 8) & 255) / 255), decoded((value & 255) / 255)];
}

function hexOf(linear: Linear): string {
  const channels = linear.map((channel) => Math.round(encoded(Math.min(1, Math.max(0, channel))) * 255));
  return `#${channels.map((channel) => channel.toString(16).padStart(2, "0")).join("")}`;
}

function decoded(channel: number): number {
  return channel <= 0.04045 ? channel / 12.92 : ((channel + 0.055) / 1.055) ** 2.4;
}

function encoded(channel: number): number {
  return channel <= 0.0031308 ? channel * 12.92 : 1.055 * channel ** (1 / 2.4) - 0.055;
}

function labOf([r, g, b]: Linear): readonly [lightness: number, a: number, b: number] {
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

function linearFromLab(lightness: number, a: number, b: number): Linear {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
}
