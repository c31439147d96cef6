import { Color, Scene } from "three";
import type { Obstacle, Stage, Track } from "../../document/scene";
import type { Show } from "../../playback/show";
import type { Size } from "../camera";
import type { Cast } from "../cast";
import { ClashFinder } from "../clashes";
import { Frame } from "../frame";
import type { Palette } from "../palette";
import type { Scenery } from "../scenery";
import { sheetOf } from "../sheet";
import { fade, screenSpacing, smoothstep, spacingAt } from "../spacing";
import type { Layers } from "../view";
import { createAirspace } from "./air";
import { type BodyKind, DISC_HEIGHT } from "./bodies";
import { createCrowd, markRadius, type Togetherness } from "./crowd";
import { createDevice } from "./device";
import type { Meetable } from "./finger";
import { createGround } from "./ground";
import { createObstacles } from "./obstacles";
import type { Orbit } from "./orbit";
import type { Sight } from "./sight";
import type { BodySizes } from "./sizes";
import { createWriting } from "./writing";

/** What is to be seen at one time; one is kept and refilled. */
export interface WorldPicture {
  show: Show;
  track: Track;
  time: number;
  scenery: Scenery;
  /** 1 for agents whose ties always show. */
  isMarked: Uint8Array | null;
  /** Drawing does not keep up with playing. */
  isSparing: boolean;
  stage: Stage;
  units: Stage["units"];
  obstacles: readonly Obstacle[];
  /** The obstacle that is selected. */
  chosen: number | null;
  kind: BodyKind;
  sizes: BodySizes;
  layers: Layers;
  selected: ReadonlySet<number>;
  hovered: number | null;
  minimumDistance: number;
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
  /** How high obstacles stand, meters. */
  obstacleHeight(): number;
  dispose(): void;
}

/** Seconds that the trails of a transition stay into the next. */
const LINGER = 0.4;

/** A hull reaches this far about each of its agents, in spacings: as on the plan, half as far as it is wide. */
const HULL_REACH = 1.15;
/** CSS pixels. */
const LARGEST_HULL = 42;

/** Obstacles in heights of a figure, which sees over them; and how much darker than the sheet they are. */
const OBSTACLE_HEIGHT = 0.5;
const OBSTACLE_SHADE = 0.14;

/** Throws `NoGraphics` where the browser draws nothing in three dimensions. */
export function createWorld(host: HTMLElement, picture: WorldPicture, onLost: () => void): World {
  const device = createDevice(host, onLost);
  const writing = createWriting(host);
  const space = new Scene();
  // Agents move in the shaders; the rest moves only when it is made anew.
  space.matrixWorldAutoUpdate = false;
  const ground = createGround(device.largestTexture, device.sharpness);
  const airspace = createAirspace();
  const obstacles = createObstacles();
  space.add(ground.mesh, airspace.lines, obstacles.group);
  const meetable: Meetable = { place: new Float32Array(0), height: 0, radius: 0, shares: new Float32Array(0) };
  const clashes = new ClashFinder();
  const together: Togetherness = {
    scenery: picture.scenery,
    share: 0,
    tieStrength: 0,
    isMarked: null,
    hullAlpha: 0,
    hullReach: 1,
    spacing: 1,
  };
  let crowd = createCrowd(0);
  let frame: Frame | null = null;

  function drawGround(palette: Palette, cast: Cast): void {
    frame ??= new Frame(palette, cast);
    frame.palette = palette;
    const sheet = sheetOf(picture.stage);
    ground.draw(frame, picture.stage, sheet);
    device.clearTo(new Color(palette.ground));
    airspace.fit(sheet, picture.stage.height);
    airspace.setColor(new Color(palette.lineStrong));
    obstacles.build(picture.obstacles, obstacleHeight(), picture.chosen);
    obstacles.setColors(
      new Color(palette.sheet).lerp(new Color(palette.ink3), OBSTACLE_SHADE),
      new Color(palette.ink3),
      new Color(palette.you),
    );
  }

  const obstacleHeight = () => OBSTACLE_HEIGHT * picture.sizes.figure;

  /** Another number of agents is another crowd. Answers whether it is. */
  function gather(): boolean {
    const { agentCount } = picture.show;
    if (crowd.count === agentCount) return false;
    space.remove(crowd.group);
    crowd.dispose();
    crowd = createCrowd(agentCount);
    space.add(crowd.group);
    meetable.place = crowd.place;
    meetable.shares = crowd.shares;
    return true;
  }

  function pose(): void {
    const { track, show, time, kind, sizes } = picture;
    crowd.pose(track, show, time, kind, sizes);
    meetable.height = kind === "figures" ? sizes.figure : DISC_HEIGHT * sizes.disc;
    meetable.radius = markRadius(kind, sizes);
    trail();
    clashes.find(crowd.xy, show.isBlendedAt(time) ? 0 : picture.minimumDistance, show.isSpatial ? crowd.heights : null);
  }

  /** Ties and hulls, which give way where they crowd the screen. */
  function relate(palette: Palette, sight: Sight): void {
    const { show, track, time, layers, scenery, orbit } = picture;
    /** CSS pixels a meter, where the eye looks. */
    const scale = sight.focal / orbit.distance;
    const spacing = spacingAt(track, time);
    const seen = screenSpacing(spacing, scale);
    together.scenery = scenery;
    together.share = show.progressAt(time) ?? 0;
    together.tieStrength = layers.ties ? fade(seen, 7, 20) : 0;
    together.isMarked = layers.ties ? picture.isMarked : null;
    together.hullAlpha = layers.groups ? palette.hullAlpha * fade(seen, 11, 16) : 0;
    together.spacing = spacing;
    together.hullReach = Math.min(HULL_REACH * seen, LARGEST_HULL) / scale;
    crowd.relate(together);
  }

  /** Of the transition under way, and first of the one before; standing, of the one that led here. */
  function trail(): void {
    const { show, time, layers } = picture;
    const segment = show.segmentAt(time);
    const before = (segment ?? show.keyframeBefore(time)) - 1;
    const since = segment === null ? 0 : time - show.startOf(segment);
    const earlier = since < LINGER ? show.motionOf(before) : null;
    const motion = earlier ?? (segment === null ? null : show.motionOf(segment));
    const strength = earlier ? 1 - smoothstep(0, LINGER, since) : 1;
    crowd.trail(layers.trails ? motion : null, earlier ? earlier.end : time, strength, meetable.radius);
  }

  return {
    resize(size) {
      device.resize(size);
      writing.resize(size, device.density);
    },
    paint(palette, cast, sight, needs) {
      if (needs.ground) drawGround(palette, cast);
      const isNew = gather();
      if (needs.ground || isNew) space.updateMatrixWorld(true);
      if (needs.cast || isNew) {
        crowd.paint(palette, cast);
        crowd.choose(picture.selected);
      }
      if (needs.poses || isNew) pose();
      relate(palette, sight);
      device.draw(space, sight, picture.orbit, picture.isSparing);
      writing.draw({ cast, palette, bodies: meetable, sight }, picture, clashes);
    },
    bodies: () => meetable,
    obstacleHeight,
    dispose() {
      crowd.dispose();
      ground.dispose();
      airspace.dispose();
      obstacles.dispose();
      writing.dispose();
      device.dispose();
    },
  };
}
