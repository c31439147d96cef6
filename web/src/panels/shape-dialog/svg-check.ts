/** Elements an SVG is refused for: the picture would lack them, or they would do more than be seen. */
const UNWELCOME: Readonly<Record<string, string>> = {
  script: "has a script in it",
  foreignobject: "has a page in it",
  iframe: "has a page in it",
  a: "has a link in it",
  image: "has a picture in it; use that picture itself",
  text: "has text in it; turn the text into paths first",
  animate: "moves",
};

/**
 * Why an SVG is not drawn, in words that follow its name; null for one that is only shapes. It is parsed as data: nothing in
 * it runs or is fetched.
 */
export function svgRefusal(text: string): string | null {
  const parsed = new DOMParser().parseFromString(text, "image/svg+xml");
  if (parsed.querySelector("parsererror")) return "cannot be read; it may be cut short.";
  if (parsed.documentElement.localName !== "svg") return "is no SVG.";
  const what = unwelcomeIn(parsed);
  return what && `${what}. Only shapes are drawn.`;
}

function unwelcomeIn(parsed: Document): string | null {
  for (const element of parsed.querySelectorAll("*")) {
    const why = UNWELCOME[element.localName.toLowerCase()];
    if (why) return why;
    if (element.localName === "style" && fetches(element.textContent)) return "links to something outside";
    for (const { localName, value } of element.attributes) {
      if (localName.toLowerCase().startsWith("on")) return "has a script in it";
      const isLink = localName.toLowerCase() === "href" && !value.trim().startsWith("#");
      if (isLink || fetches(value)) return "links to something outside";
    }
  }
  return null;
}

/** Whether a style asks for anything but a part of the drawing. */
function fetches(style: string): boolean {
  return style.includes("@import") || /url\(\s*["']?(?!\s*["']?#)[^\s"']/.test(style);
}
