import {
  type BufferGeometry,
  type Color,
  CylinderGeometry,
  EdgesGeometry,
  ExtrudeGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Shape,
  Vector2,
} from "three";
import type { Obstacle, ObstacleShape } from "../../document/scene";

/** Edges between faces that meet at less than this are not drawn, degrees: a round wall has none. */
const SOFT_EDGE = 30;

/** What agents go around, as low blocks. */
export interface Obstacles {
  readonly group: Group;
  /** Builds them anew, `height` meters high; the selected one's edges are the person's. */
  build(obstacles: readonly Obstacle[], height: number, selected: number | null): void;
  setColors(face: Color, edge: Color, you: Color): void;
  dispose(): void;
}

export function createObstacles(): Obstacles {
  const group = new Group();
  // Faces give way to their own edges.
  const face = new MeshBasicMaterial({ polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  const edge = new LineBasicMaterial();
  const chosenEdge = new LineBasicMaterial();
  let geometries: BufferGeometry[] = [];

  function clear(): void {
    for (const geometry of geometries) geometry.dispose();
    geometries = [];
    group.clear();
  }

  return {
    group,
    build(obstacles, height, selected) {
      clear();
      obstacles.forEach(({ shape }, index) => {
        const block = blockOf(shape, height);
        const edges = new EdgesGeometry(block, SOFT_EDGE);
        geometries.push(block, edges);
        group.add(new Mesh(block, face), new LineSegments(edges, index === selected ? chosenEdge : edge));
      });
    },
    setColors(faceColor, edgeColor, you) {
      face.color = faceColor;
      edge.color = edgeColor;
      chosenEdge.color = you;
    },
    dispose() {
      clear();
      face.dispose();
      edge.dispose();
      chosenEdge.dispose();
    },
  };
}

function blockOf(shape: ObstacleShape, height: number): BufferGeometry {
  if (shape.kind === "circle") {
    const [x, y] = shape.center;
    const block = new CylinderGeometry(shape.radius, shape.radius, height, 48);
    return block.rotateX(Math.PI / 2).translate(x, y, height / 2);
  }
  const outline = new Shape(shape.points.map(([x, y]) => new Vector2(x, y)));
  return new ExtrudeGeometry(outline, { depth: height, bevelEnabled: false });
}
