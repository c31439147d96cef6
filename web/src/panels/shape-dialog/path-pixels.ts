import { isPathData } from "./path-check";
import { drawnPixels, NoPixels, NothingYet, type Pixels, SIDE } from "./pixels";

const NO_INSIDE = "This path has no inside; one that has is M 0 0 L 4 0 L 2 3 Z.";

const SVG = "http://www.w3.org/2000/svg";

/** The inside of an SVG path, however large its numbers are. */
export function pathPixels(data: string): Pixels {
  if (data.trim() === "") throw new NothingYet("Give the path of an SVG, such as M 0 0 L 4 0 L 2 3 Z.");
  if (!isPathData(data)) throw new NoPixels("This is no path; one is M 0 0 L 4 0 L 2 3 Z.");
  const { x, y, width, height } = boundsOf(data);
  if (!(width > 0 && height > 0)) throw new NoPixels(NO_INSIDE);
  const scale = SIDE / Math.max(width, height);
  const pixels = drawnPixels(width * scale + 2, height * scale + 2, (context) => {
    context.setTransform(scale, 0, 0, scale, 1 - x * scale, 1 - y * scale);
    context.fill(new Path2D(data));
  });
  // A line on a slant has a box, and nothing in it.
  if (pixels.rgba.every((byte) => byte === 0)) throw new NoPixels(NO_INSIDE);
  return pixels;
}

/** The browser knows the box of a path only while it is on the page. */
function boundsOf(data: string): DOMRect {
  const svg = document.createElementNS(SVG, "svg");
  const path = document.createElementNS(SVG, "path");
  path.setAttribute("d", data);
  svg.append(path);
  svg.classList.add("unseen");
  document.body.append(svg);
  try {
    return path.getBBox();
  } finally {
    svg.remove();
  }
}
