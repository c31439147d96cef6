import { useLayoutEffect, useRef } from "preact/hooks";
import type { Keyframe } from "../../document/scene";
import type { Palette } from "../../stage/palette";
import { drawFormation } from "./thumbnail-drawing";

const SIZE = { width: 76, height: 54 };

export interface ThumbnailProps {
  readonly keyframe: Keyframe;
  /** Stored colors by agent. */
  readonly colors: readonly string[];
  readonly palette: Palette;
}

/** The formation in small, of those who are there. Drawn again only when it, the colors or the theme change. */
export function Thumbnail({ keyframe, colors, palette }: ThumbnailProps) {
  const { positions, absent } = keyframe;
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    if (canvas.current) drawFormation(canvas.current, SIZE, { positions, absent }, colors, palette);
  }, [positions, absent, colors, palette]);
  return <canvas ref={canvas} width={SIZE.width} height={SIZE.height} />;
}
