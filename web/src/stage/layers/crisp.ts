/** The middle of the pixel nearest to a coordinate: a line of 1 px is sharp there. */
export function crisp(value: number): number {
  return Math.round(value) + 0.5;
}
