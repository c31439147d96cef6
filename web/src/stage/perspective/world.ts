import { Color, Scene } from "three";
import type { Obstacle, Stage } from "../../document/scene";
import type { Show } from "../../playback/show";
import type { Size } from "../camera";
import { createContext } from "../canvases";
import type { Cast } from "../cast";
import { Frame } from "../frame";
import type { Palette } from "../palette";
import { sheetOf } from "../sheet";
import { smoothstep } from "../spacing";
import { createAirspace } from "./air";
import { type BodyKind, DISC_HEIGHT } from "./bodies";
import { createCrowd, markRadius } from "./crowd";
import { createDevice } from "./device";
import type { Meetable } from "./finger";
import { createGround } from "./ground";
import { drawNames, hasNames } from "./names";
import { createObstacles } from "./obstacles";
import type { Orbit } from "./orbit";
import type { Sight } from "./sight";
import type { BodySizes } from "./sizes";

/** What is to be seen at one time; one is kept and refilled. */
export interface WorldPicture {
  show: Show;
  time: number;
  /** Drawing does not keep up with playing. */
  isSparing: boolean;
  stage: Stage;
  obstacles: readonly Obstacle[];
  kind: BodyKind;
  sizes: BodySizes;
  hasTrails: boolean;
  selected: ReadonlySet<number>;
  hovered: number | null;
  orbit: Orbit;
}

/** Which parts of the world are old. */
export interface WorldNeeds {
  ground: boolean;
  cast: boolean;
  poses: boolean;
}

/** Everything that is seen in perspective, and the canvases it is seen on. */
export interface World {
  resize(size: Size): void;
  paint(palette: Palette, cast: Cast, sight: Sight, needs: Readonly<WorldNeeds>): void;
  /** What a pointer can meet, as it was last drawn. */
  bodies(): Meetable;
  dispose(): void;
}

/** Seconds that the trails of a transition stay into the next. */
const LINGER = 0.4;

/** Obstacles in heights of a figure, which sees over them; and how much darker than the sheet they are. */
const OBSTACLE_HEIGHT = 0.5;
const OBSTACLE_SHADE = 0.14;

/** Throws `NoGraphics` where the browser draws nothing in three dimensions. */
export function createWorld(host: HTMLElement, picture: WorldPicture, onLost: () => void): World {
  const device = createDevice(host, onLost);
  const words = createContext(1, 1);
  words.canvas.setAttribute("aria-hidden", "true");
  host.append(words.canvas);
  const space = new Scene();
  const ground = createGround(device.largestTexture, device.sharpness);
  const airspace = createAirspace();
  const obstacles = createObstacles();
  space.add(ground.mesh, airspace.lines, obstacles.group);
  const meetable: Meetable = { place: new Float32Array(0), height: 0, radius: 0 };
  let crowd = createCrowd(0);
  let frame: Frame | null = null;
  let size: Size = { width: 0, height: 0 };

  function drawGround(palette: Palette, cast: Cast): void {
    frame ??= new Frame(palette, cast);
    frame.palette = palette;
    const sheet = sheetOf(picture.stage);
    ground.draw(frame, picture.stage, sheet);
    device.clearTo(new Color(palette.ground));
    airspace.fit(sheet, picture.stage.height);
    airspace.setColor(new Color(palette.lineStrong));
    obstacles.build(picture.obstacles, OBSTACLE_HEIGHT * picture.sizes.figure);
    obstacles.setColors(
      new Color(palette.sheet).lerp(new Color(palette.ink3), OBSTACLE_SHADE),
      new Color(palette.ink3),
    );
  }

  /** Another number of agents is another crowd. Answers whether it is. */
  function gather(): boolean {
    const { agentCount } = picture.show;
    if (crowd.count === agentCount) return false;
    space.remove(crowd.group);
    crowd.dispose();
    crowd = createCrowd(agentCount);
    space.add(crowd.group);
    meetable.place = crowd.place;
    return true;
  }

  function pose(): void {
    const { show, time, kind, sizes } = picture;
    crowd.pose(show, time, kind, sizes);
    meetable.height = kind === "figures" ? sizes.figure : DISC_HEIGHT * sizes.disc;
    meetable.radius = markRadius(kind, sizes);
    trail();
  }

  /** Of the transition under way, and first of the one before; standing, of the one that led here. */
  function trail(): void {
    const { show, time, hasTrails } = picture;
    const segment = show.segmentAt(time);
    const before = (segment ?? show.keyframeBefore(time)) - 1;
    const since = segment === null ? 0 : time - show.startOf(segment);
    const earlier = since < LINGER ? show.motionOf(before) : null;
    const motion = earlier ?? (segment === null ? null : show.motionOf(segment));
    const strength = earlier ? 1 - smoothstep(0, LINGER, since) : 1;
    crowd.trail(hasTrails ? motion : null, earlier ? earlier.end : time, strength, meetable.radius);
  }

  return {
    resize(next) {
      size = next;
      device.resize(size);
      words.canvas.width = Math.max(1, Math.round(size.width * device.density));
      words.canvas.height = Math.max(1, Math.round(size.height * device.density));
      words.setTransform(device.density, 0, 0, device.density, 0, 0);
    },
    paint(palette, cast, sight, needs) {
      if (needs.ground) drawGround(palette, cast);
      const isNew = gather();
      if (needs.cast || isNew) {
        crowd.paint(palette, cast);
        crowd.choose(picture.selected);
      }
      if (needs.poses || isNew) pose();
      device.draw(space, sight, picture.orbit, picture.isSparing);
      const { hovered, selected } = picture;
      const areNamed = hasNames(hovered, selected);
      // An empty sheet laid over the other would cost every frame.
      words.canvas.hidden = !areNamed;
      if (areNamed) drawNames(words, size, { cast, palette, bodies: meetable, sight }, hovered, selected);
    },
    bodies: () => meetable,
    dispose() {
      crowd.dispose();
      ground.dispose();
      airspace.dispose();
      obstacles.dispose();
      words.canvas.remove();
      device.dispose();
    },
  };
}
