import { useEffect, useState } from "preact/hooks";
import { pathPixels } from "./path-pixels";
import { picturePixels } from "./picture-pixels";
import { NothingYet, type Pixels } from "./pixels";
import { textPixels } from "./text-pixels";

/** What a shape is drawn from. */
export type Origin =
  | { readonly kind: "picture"; readonly file: File | null }
  | { readonly kind: "text"; readonly text: string; readonly font: string }
  | { readonly kind: "path"; readonly data: string };

export type Drawn =
  /** What to give, a sentence; empty where that is plain. */
  | { readonly kind: "none"; readonly what: string }
  | { readonly kind: "here"; readonly pixels: Pixels }
  /** A sentence. */
  | { readonly kind: "refused"; readonly what: string };

const NONE: Drawn = { kind: "none", what: "" };

/** The pixels of an origin, drawn anew when it changes. */
export function usePixels(origin: Origin): Drawn {
  const [drawn, setDrawn] = useState<Drawn>(NONE);
  const parts =
    origin.kind === "picture" ? [origin.file] : origin.kind === "text" ? [origin.text, origin.font] : [origin.data];
  useEffect(() => {
    let isWanted = true;
    const draw = async (): Promise<Drawn> => {
      if (origin.kind === "picture" && !origin.file) return NONE;
      try {
        return { kind: "here", pixels: await pixelsFrom(origin) };
      } catch (error) {
        if (error instanceof NothingYet) return { kind: "none", what: error.message };
        return { kind: "refused", what: error instanceof Error ? error.message : String(error) };
      }
    };
    void draw().then((next) => isWanted && setDrawn(next));
    return () => {
      isWanted = false;
    };
  }, [origin.kind, ...parts]);
  return drawn;
}

async function pixelsFrom(origin: Origin): Promise<Pixels> {
  switch (origin.kind) {
    case "text":
      return textPixels(origin.text, origin.font);
    case "path":
      return pathPixels(origin.data);
    case "picture":
      if (!origin.file) throw new Error("no picture is chosen");
      return picturePixels(origin.file);
  }
}
