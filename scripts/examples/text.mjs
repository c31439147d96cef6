/** A scene file that a person can read: a line for each field, agent list, group and keyframe. */
export function sceneText(scene) {
  const fields = Object.entries(scene).map(([name, value]) => `  ${JSON.stringify(name)}: ${fieldText(value)}`);
  return `{\n${fields.join(",\n")}\n}\n`;
}

function fieldText(value) {
  const isLong = Array.isArray(value) && value.some((entry) => typeof entry === "object");
  if (!isLong) return JSON.stringify(value);
  return `[\n${value.map((entry) => `    ${JSON.stringify(entry)}`).join(",\n")}\n  ]`;
}
