import { signal } from "@preact/signals";

/** Counts the parts that came, so that whoever draws with one draws again. */
export const arrivals = signal(0);

/** A part of the drawing that is fetched when it is first needed; null until then. One that fails is tried at the next need. */
export function later<Part>(load: () => Promise<Part>): () => Part | null {
  let part: Part | null = null;
  let isLoading = false;
  return () => {
    if (part === null && !isLoading) {
      isLoading = true;
      load()
        .then((loaded) => {
          part = loaded;
          arrivals.value += 1;
        })
        .catch(() => {})
        .finally(() => {
          isLoading = false;
        });
    }
    return part;
  };
}
