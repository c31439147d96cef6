/** Calls back when the page comes to a screen with other pixels. Answers how to stop. */
export function onDensityChange(changed: () => void): () => void {
  let query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
  const listen = () => {
    query.removeEventListener("change", listen);
    query = matchMedia(`(resolution: ${devicePixelRatio}dppx)`);
    query.addEventListener("change", listen);
    changed();
  };
  query.addEventListener("change", listen);
  return () => query.removeEventListener("change", listen);
}
