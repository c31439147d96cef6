/** Characters that a disc holds. */
const ROOM = 4;

/** A name cut to a disc: `Trumpet 12` is T12, `Anna Maria` AM, `Katharina` Kat; a short one stays. */
export function shortName(name: string): string {
  if ([...name].length <= ROOM) return name;
  const words = name.split(/[\s_-]+/).filter((word) => word !== "");
  const number = /\d+$/.exec(name)?.[0] ?? "";
  const letters = words.filter((word) => !/^\d+$/.test(word)).map((word) => [...word]);
  const initials = letters.map(([first = ""]) => first).join("");
  if (number !== "" && number.length < ROOM) return [...initials].slice(0, ROOM - number.length).join("") + number;
  if (letters.length > 1) return [...initials].slice(0, 3).join("");
  return (letters[0] ?? [...name]).slice(0, 3).join("");
}
