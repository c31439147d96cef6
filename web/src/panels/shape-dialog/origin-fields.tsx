import { useRef } from "preact/hooks";
import { TextField } from "./text-field";
import { TEXT_LIMIT } from "./text-pixels";
import type { Origin } from "./use-pixels";

/** Characters of a path: a detailed outline. */
const PATH_LIMIT = 100_000;

/** What the shape is drawn from: a picture to choose, text and its font, or a path. */
export function OriginFields({ origin, onChange }: { origin: Origin; onChange(origin: Origin): void }) {
  switch (origin.kind) {
    case "picture":
      return <PictureField file={origin.file} onChoose={(file) => onChange({ kind: "picture", file })} />;
    case "text":
      return (
        <>
          <TextField
            label="Text"
            value={origin.text}
            limit={TEXT_LIMIT}
            onInput={(text) => onChange({ ...origin, text })}
          />
          <TextField
            label="Font"
            value={origin.font}
            placeholder="Any installed font"
            limit={100}
            onInput={(font) => onChange({ ...origin, font })}
          />
        </>
      );
    case "path":
      return (
        <TextField
          label="Path"
          value={origin.data}
          placeholder="M 0 0 L 4 0 L 2 3 Z"
          limit={PATH_LIMIT}
          onInput={(data) => onChange({ kind: "path", data })}
        />
      );
  }
}

function PictureField({ file, onChoose }: { file: File | null; onChoose(file: File): void }) {
  const input = useRef<HTMLInputElement>(null);
  return (
    <div class="picture-field">
      <input
        ref={input}
        type="file"
        class="unseen"
        tabIndex={-1}
        aria-label="Picture file"
        accept="image/png,image/jpeg,image/webp,image/svg+xml,.svg"
        onChange={(event) => {
          const chosen = event.currentTarget.files?.[0];
          if (chosen) onChoose(chosen);
        }}
      />
      <button type="button" class="button" onClick={() => input.current?.click()}>
        {file ? "Another picture…" : "Choose a picture…"}
      </button>
      <p class="picture-name">{file?.name ?? "PNG, JPEG, WebP or SVG; it can be dropped or pasted, too."}</p>
    </div>
  );
}
