import { CanvasTexture, LinearMipmapLinearFilter, Mesh, MeshBasicMaterial, PlaneGeometry } from "three";
import type { Stage } from "../../document/scene";
import type { Bounds, Camera, Size } from "../camera";
import { createContext } from "../canvases";
import type { Frame } from "../frame";
import { drawBackdrop } from "../layers/backdrop";

/** The sheet's longer side, and the room around it for its numbers and words, CSS pixels. */
const LONGER_SIDE = 960;
const MARGIN = 48;

/** The ground as the plan draws it, to be laid down. */
export interface GroundPicture {
  readonly camera: Camera;
  readonly size: Size;
  /** Canvas pixels a CSS pixel. */
  readonly density: number;
  /** What the picture covers, meters. */
  readonly bounds: Bounds;
}

/** A picture of all of `sheet` and a margin, at most `limit` canvas pixels either way. */
export function groundPicture(sheet: Bounds, limit: number): GroundPicture {
  const [across, deep] = [sheet.maxX - sheet.minX, sheet.maxY - sheet.minY];
  const scale = LONGER_SIDE / Math.max(across, deep);
  const size = { width: across * scale + 2 * MARGIN, height: deep * scale + 2 * MARGIN };
  const margin = MARGIN / scale;
  return {
    camera: { scale, left: MARGIN - sheet.minX * scale, top: MARGIN + sheet.maxY * scale },
    size,
    density: limit / Math.max(size.width, size.height),
    bounds: {
      minX: sheet.minX - margin,
      maxX: sheet.maxX + margin,
      minY: sheet.minY - margin,
      maxY: sheet.maxY + margin,
    },
  };
}

/** What the agents stand on. */
export interface Ground {
  readonly mesh: Mesh;
  draw(frame: Frame, stage: Stage, sheet: Bounds): void;
  dispose(): void;
}

/** @param limit the largest texture, pixels @param sharpness samples along the slope */
export function createGround(limit: number, sharpness: number): Ground {
  const context = createContext(1, 1, true);
  const geometry = new PlaneGeometry(1, 1);
  const material = new MeshBasicMaterial({ depthWrite: false });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.renderOrder = -1;
  return {
    mesh,
    draw(frame, stage, sheet) {
      const { camera, size, density, bounds } = groundPicture(sheet, limit);
      // A row of pixels that is covered in part only would show as a line.
      context.canvas.width = Math.floor(size.width * density);
      context.canvas.height = Math.floor(size.height * density);
      context.setTransform(density, 0, 0, density, 0, 0);
      frame.look(camera, size, density, 0);
      drawBackdrop(context, frame, stage);
      // A texture keeps the size it was first sent with.
      material.map?.dispose();
      const texture = new CanvasTexture(context.canvas);
      texture.minFilter = LinearMipmapLinearFilter;
      texture.anisotropy = sharpness;
      material.map = texture;
      material.needsUpdate = true;
      mesh.scale.set(bounds.maxX - bounds.minX, bounds.maxY - bounds.minY, 1);
      mesh.position.set((bounds.minX + bounds.maxX) / 2, (bounds.minY + bounds.maxY) / 2, 0);
    },
    dispose() {
      material.map?.dispose();
      material.dispose();
      geometry.dispose();
    },
  };
}
