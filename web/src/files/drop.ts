/** Files dropped anywhere on the page are to be opened; so is dropped text, such as a link. */
export function attachDrop(
  page: HTMLElement,
  openFiles: (files: readonly File[]) => void,
  openText: (text: string) => void,
): void {
  const isOurs = (event: DragEvent): boolean =>
    Boolean(event.dataTransfer?.types.some((type) => type === "Files" || type === "text/plain"));
  page.addEventListener("dragover", (event) => {
    if (!isOurs(event)) return;
    event.preventDefault();
    page.classList.add("is-drop-target");
  });
  page.addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) page.classList.remove("is-drop-target");
  });
  page.addEventListener("drop", (event) => {
    page.classList.remove("is-drop-target");
    if (!isOurs(event) || !event.dataTransfer) return;
    event.preventDefault();
    const files = [...event.dataTransfer.files];
    if (files.length > 0) openFiles(files);
    else openText(event.dataTransfer.getData("text/plain"));
  });
}

/** Asks for a file by the system's own dialog; nothing happens when the person thinks better of it. */
export function pickFile(openFile: (file: File) => void): void {
  const input = document.createElement("input");
  input.type = "file";
  input.accept = ".json,.csv,.txt,application/json,text/csv,text/plain,.png,.jpg,.jpeg,.webp,.svg";
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    if (file) openFile(file);
  });
  input.click();
}
