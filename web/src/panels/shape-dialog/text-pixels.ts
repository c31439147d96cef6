import { drawnPixels, NoPixels, NothingYet, type Pixels, SIDE } from "./pixels";

/** Characters of a text that makes a formation. */
export const TEXT_LIMIT = 200;

/** Pixels a letter is measured and looked at with. */
const MEASURED = 100;

/** A place of no script: no font draws anything for it but the sign that it has nothing. */
const NOTHING = "\u{10FFFD}";

/** Text in a font of this machine; the note says where the font is another one. */
export function textPixels(text: string, font: string): Pixels {
  const letters = text.trim();
  if (letters === "") throw new NothingYet("Type the text that the agents shall stand in.");
  const families = `${font.trim() ? `"${font.trim().replace(/["\\]/g, "")}", ` : ""}sans-serif`;
  const missing = [...letters].find((letter) => letter.trim() !== "" && isMissing(letter, families));
  if (missing) throw new NoPixels(`No font of this machine has “${missing}”.`);
  const box = measured(letters, families);
  const scale = SIDE / Math.max(box.width, box.height, 1);
  const note =
    font.trim() && !isInstalled(font.trim())
      ? `${font.trim()} is not on this machine; the text stands in another font.`
      : "";
  return drawnPixels(
    box.width * scale + 2,
    box.height * scale + 2,
    (context) => {
      context.font = `${MEASURED * scale}px ${families}`;
      context.fillText(letters, box.left * scale + 1, box.above * scale + 1);
    },
    note,
  );
}

interface TextBox {
  readonly width: number;
  readonly height: number;
  /** From the left edge of the ink to where the text begins, and from its upper edge to the line it stands on. */
  readonly left: number;
  readonly above: number;
}

/** The box around what is inked of a text. */
function measured(text: string, families: string): TextBox {
  const context = document.createElement("canvas").getContext("2d");
  if (!context) throw new NoPixels("This browser gives no canvas to draw on.");
  context.font = `${MEASURED}px ${families}`;
  const ink = context.measureText(text);
  return {
    width: ink.actualBoundingBoxLeft + ink.actualBoundingBoxRight,
    height: ink.actualBoundingBoxAscent + ink.actualBoundingBoxDescent,
    left: ink.actualBoundingBoxLeft,
    above: ink.actualBoundingBoxAscent,
  };
}

/** Whether a letter looks like the sign for none at all. */
function isMissing(letter: string, families: string): boolean {
  const look = (text: string) =>
    drawnPixels(MEASURED, MEASURED, (context) => {
      context.font = `${MEASURED / 2}px ${families}`;
      context.fillText(text, MEASURED / 4, 0.75 * MEASURED);
    }).rgba;
  const [seen, sign] = [look(letter), look(NOTHING)];
  return seen.every((value, at) => value === sign[at]);
}

/** A font that is not there leaves the widths of whatever stands in for it. */
function isInstalled(font: string): boolean {
  const name = font.replace(/["\\]/g, "");
  return ["serif", "sans-serif", "monospace"].some(
    (other) =>
      name.toLowerCase() === other ||
      measured("mwil10", `"${name}", ${other}`).width !== measured("mwil10", other).width,
  );
}
