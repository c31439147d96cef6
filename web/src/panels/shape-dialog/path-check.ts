/** Numbers that each command of an SVG path takes, once or over and over. */
const TAKES: Readonly<Record<string, number>> = { m: 2, l: 2, h: 1, v: 1, c: 6, s: 4, q: 4, t: 2, a: 7, z: 0 };

const COMMAND = /([mlhvcsqtaz])([^mlhvcsqtaz]*)/giy;
const NUMBER = /[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?/gi;

/**
 * Whether text is the data of an SVG path: a browser draws what comes before a mistake, and complains of it where nobody
 * looks. An arc's flags need nothing between them, so only its letters are judged.
 */
export function isPathData(data: string): boolean {
  const text = data.trim();
  const commands = [...text.matchAll(COMMAND)];
  const read = commands.reduce((length, [whole]) => length + whole.length, 0);
  if (read !== text.length || commands[0]?.[1]?.toLowerCase() !== "m") return false;
  return commands.every(([, letter = "", rest = ""]) => {
    const command = letter.toLowerCase();
    const takes = TAKES[command] ?? 0;
    const count = rest.match(NUMBER)?.length ?? 0;
    if (/[^\s,]/.test(rest.replace(NUMBER, ""))) return false;
    if (command === "a") return count > 0;
    return takes === 0 ? count === 0 : count > 0 && count % takes === 0;
  });
}
