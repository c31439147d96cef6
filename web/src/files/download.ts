/** Hands the person a file. */
export function download(name: string, text: string, type: string): void {
  const url = URL.createObjectURL(new Blob([text], { type }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  // The download reads the blob after this turn.
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}

/** A file name that every system takes, from whatever the person called the scene. */
export function fileName(title: string, ending: string): string {
  const stem = title
    .normalize("NFC")
    .replace(/[^\p{Letter}\p{Number} _-]+/gu, " ")
    .trim()
    .replace(/\s+/g, "-")
    .slice(0, 60);
  return `${stem || "scene"}.${ending}`;
}
