/** The example that a newcomer sees play. */
export const FIRST_EXAMPLE = "band";

/** Where an example's scene is fetched from, beside the page. */
export function exampleFile(id: string): string {
  return `./examples/${id}.eigenform.json`;
}

/** The text of an example's scene, for the engine to judge like any other. */
export async function readExample(id: string): Promise<string> {
  const response = await fetch(exampleFile(id));
  if (!response.ok) throw new Error(`The example could not be fetched (${response.status}).`);
  return response.text();
}

/** The text of an example's recording. */
export async function readRecording(id: string): Promise<string> {
  const response = await fetch(`./examples/${id}.txt`);
  if (!response.ok) throw new Error(`The recording could not be fetched (${response.status}).`);
  return response.text();
}
