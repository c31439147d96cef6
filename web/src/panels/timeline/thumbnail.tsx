import { useLayoutEffect, useRef } from "preact/hooks";
import type { Formation } from "../../document/formation";
import type { Palette } from "../../stage/palette";
import { drawFormation } from "./thumbnail-drawing";

const SIZE = { width: 76, height: 54 };

export interface ThumbnailProps {
  readonly formation: Formation;
  /** Stored colors by agent. */
  readonly colors: readonly string[];
  readonly palette: Palette;
}

/** The formation in small. Drawn again only when it, the colors or the theme change. */
export function Thumbnail({ formation, colors, palette }: ThumbnailProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    if (canvas.current) drawFormation(canvas.current, SIZE, formation, colors, palette);
  }, [formation, colors, palette]);
  return <canvas ref={canvas} width={SIZE.width} height={SIZE.height} />;
}
