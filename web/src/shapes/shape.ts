import { type Box, centerOf } from "../document/box";
import type { Point } from "../document/formation";
import { distance, placesAlong, placesOnCorners } from "./path";
import {
  arcOutline,
  arcOver,
  circleOutline,
  INNER_SHARE,
  placesOnArc,
  placesOnChord,
  placesOnCircle,
  placesOnRing,
} from "./round";
import { placesInBlock, placesInGrid } from "./rows";
import type { Spacing } from "./spacing";

export type ShapeName = "line" | "arc" | "circle" | "ring" | "block" | "grid" | "triangle" | "star";

/** Where a shape puts agents, and what is drawn of it, meters. */
export interface PlacedShape {
  readonly places: readonly Point[];
  readonly outline: readonly Point[];
}

/** A side that was hardly drawn is taken as this share of the other, so that a shape keeps its corners apart. */
const FLATTEST = 0.1;

/** The inner corners of a star, as a share of its outer ones. */
const STAR_INNER = 0.5;

/** A shape drawn from one corner of its box to the opposite one; exactly as many places as asked, all distinct. */
export function placeShape(name: ShapeName, from: Point, to: Point, spacing: Spacing): PlacedShape {
  const box: Box = {
    min: [Math.min(from[0], to[0]), Math.min(from[1], to[1])],
    max: [Math.max(from[0], to[0]), Math.max(from[1], to[1])],
  };
  switch (name) {
    case "line":
      return { places: placesAlong([from, to], spacing), outline: [from, to] };
    case "arc":
      return placeArc(from, to, spacing);
    case "circle":
    case "ring":
      return placeRound(name, from, to, spacing);
    case "block":
      return { places: placesInBlock(box, spacing), outline: edgeOf(box) };
    case "grid":
      return { places: placesInGrid(box, spacing), outline: edgeOf(box) };
    case "triangle":
      return placeCorners(triangleIn(roomy(box)), spacing);
    case "star":
      return placeCorners(starIn(roomy(box)), spacing);
  }
}

function placeArc(from: Point, to: Point, spacing: Spacing): PlacedShape {
  const arc = arcOver(from, to[0] - from[0], to[1] - from[1]);
  if (arc) return { places: placesOnArc(arc, spacing), outline: arcOutline(arc) };
  const isUpright = to[0] === from[0];
  const places = isUpright ? placesAlong([from, to], spacing) : placesOnChord(from, to[0] - from[0], spacing);
  return { places, outline: [from, to] };
}

function placeRound(name: "circle" | "ring", from: Point, to: Point, spacing: Spacing): PlacedShape {
  const radius = Math.max(Math.abs(to[0] - from[0]), Math.abs(to[1] - from[1])) / 2;
  const center: Point = [from[0] + radius * (to[0] < from[0] ? -1 : 1), from[1] + radius * (to[1] > from[1] ? 1 : -1)];
  const outer = circleOutline(center, radius);
  if (name === "circle") return { places: placesOnCircle(center, radius, spacing), outline: outer };
  const inner = circleOutline(center, radius * INNER_SHARE);
  return { places: placesOnRing(center, radius, spacing), outline: [...outer, ...inner] };
}

function placeCorners(corners: readonly Point[], spacing: Spacing): PlacedShape {
  return { places: placesOnCorners(corners, spacing), outline: [...corners, ...corners.slice(0, 1)] };
}

function triangleIn({ min, max }: Box): Point[] {
  return [
    [(min[0] + max[0]) / 2, max[1]],
    [max[0], min[1]],
    [min[0], min[1]],
  ];
}

/** Five points, one of them away from the audience, stretched to the box. */
function starIn(box: Box): Point[] {
  const turns = Array.from({ length: 10 }, (_, i): Point => {
    const reach = i % 2 === 0 ? 1 : STAR_INNER;
    const angle = Math.PI / 2 - (i * Math.PI) / 5;
    return [reach * Math.cos(angle), reach * Math.sin(angle)];
  });
  const [xs, ys] = [turns.map(([x]) => x), turns.map(([, y]) => y)];
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  return turns.map(
    ([x, y]): Point => [
      box.min[0] + ((x - left) / (right - left)) * (box.max[0] - box.min[0]),
      box.min[1] + ((y - low) / (high - low)) * (box.max[1] - box.min[1]),
    ],
  );
}

function roomy(box: Box): Box {
  const least = FLATTEST * Math.max(box.max[0] - box.min[0], box.max[1] - box.min[1]);
  const center = centerOf(box);
  const half = (axis: 0 | 1) => Math.max(box.max[axis] - box.min[axis], least) / 2;
  return { min: [center[0] - half(0), center[1] - half(1)], max: [center[0] + half(0), center[1] + half(1)] };
}

function edgeOf({ min, max }: Box): Point[] {
  return [min, [max[0], min[1]], max, [min[0], max[1]], min];
}

/** Whether a drag is long enough to give a shape its size, meters. */
export function isDrawn(from: Point, to: Point, least: number): boolean {
  return distance(from, to) >= least;
}
