import { isTextField } from "./keyboard";

/** Copying and pasting agents as text, by key, by menu and by the palette. */
export interface AgentClipboard {
  /** The selected agents as text; empty when there are none. */
  copied(): string;
  paste(text: string): Promise<void>;
}

/** The browser's own copy and paste, which need no permission. Answers how to stop. */
export function attachClipboard(page: Document, agents: AgentClipboard, openFile: (file: File) => void): () => void {
  function onCopy(event: ClipboardEvent): void {
    const text = agents.copied();
    const isReading = !(page.getSelection()?.isCollapsed ?? true);
    if (isTextField(event.target) || isReading || text === "" || event.defaultPrevented) return;
    event.clipboardData?.setData("text/plain", text);
    event.preventDefault();
  }
  function onPaste(event: ClipboardEvent): void {
    if (isTextField(event.target) || event.defaultPrevented) return;
    const text = event.clipboardData?.getData("text/plain") ?? "";
    const file = event.clipboardData?.files[0];
    if (text === "" && !file) return;
    event.preventDefault();
    if (text === "" && file) openFile(file);
    else void agents.paste(text);
  }
  page.addEventListener("copy", onCopy);
  page.addEventListener("paste", onPaste);
  return () => {
    page.removeEventListener("copy", onCopy);
    page.removeEventListener("paste", onPaste);
  };
}
