import { outlineInto } from "./ribbon";

const SVG = "http://www.w3.org/2000/svg";

/** Agents of the stroke that shows what Draw does. */
const AGENTS = 13;
const STROKE = { width: 360, height: 100, radius: 8 } as const;

const KEYS: readonly { readonly keys: readonly string[]; readonly does: string }[] = [
  { keys: ["D"], does: "draw" },
  { keys: ["S"], does: "shape" },
  { keys: ["Ctrl", "K"], does: "anything else" },
];

/** What a stage without agents says: how to begin. */
export function createEmptyState(): HTMLElement {
  const root = element("div", "stage-empty");
  const words = element("div", "stage-empty-words");
  const keys = element("div", "stage-empty-keys");
  for (const { keys: names, does } of KEYS) {
    const entry = element("span", "");
    for (const name of names) entry.append(element("kbd", "", name));
    entry.append(does);
    keys.append(entry);
  }
  words.append(
    element("h2", "", "Draw a formation here"),
    element("p", "", "Agents space themselves evenly along your stroke. Close it to fill."),
    keys,
  );
  root.append(drawnStroke(), words);
  return root;
}

/** A wave of agents along a ribbon, faint to firm. */
function drawnStroke(): SVGElement {
  const { width, height, radius } = STROKE;
  const picture = shape("svg", {
    class: "stage-empty-stroke",
    viewBox: `${-radius} ${-radius} ${width + 2 * radius} ${height + 2 * radius}`,
    "aria-hidden": "true",
  });
  const places = Array.from({ length: AGENTS }, (_, agent) => wave(agent / (AGENTS - 1)));
  const line = Float32Array.from(places.flat());
  const outline = new Float32Array(4 * AGENTS);
  outlineInto(line, AGENTS, 2, 9, outline, 0);
  for (let agent = 0; agent + 1 < AGENTS; agent += 1) {
    const corner = (k: number) => `${outline[4 * agent + k]?.toFixed(1)} ${outline[4 * agent + k + 1]?.toFixed(1)}`;
    picture.append(
      shape("path", {
        d: `M${corner(0)}L${corner(4)}L${corner(6)}L${corner(2)}Z`,
        opacity: (0.06 + (0.26 * agent) / AGENTS).toFixed(3),
      }),
    );
  }
  places.forEach(([x, y], agent) => {
    const place = { cx: x.toFixed(1), cy: y.toFixed(1) };
    const opacity = 0.16 + 0.84 * (agent / (AGENTS - 1)) ** 1.2;
    picture.append(shape("circle", { ...place, class: "halo", r: String(radius + 1.8) }));
    picture.append(shape("circle", { ...place, r: String(radius), opacity: opacity.toFixed(3) }));
  });
  return picture;
}

/** Up a little, down, and level at the end. */
function wave(t: number): [x: number, y: number] {
  return [t * STROKE.width, STROKE.height * (0.5 - 0.5 * Math.cos((Math.PI * (t - 0.25)) / 0.6))];
}

function element(name: string, className: string, text = ""): HTMLElement {
  const made = document.createElement(name);
  if (className) made.className = className;
  made.textContent = text;
  return made;
}

function shape(name: string, attributes: Readonly<Record<string, string>>): SVGElement {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}
