import "./dialogs.css";
import "./export.css";
import { Download } from "lucide";
import { useState } from "preact/hooks";
import { formatCount } from "../../document/units";
import { EngineError } from "../../engine/api";
import { Icon } from "../../theme/icons";
import { useStudio } from "../studio";
import { bytesWords, exportSize, frameCount } from "./export-size";
import { Frame } from "./frame";
import type { DialogProps } from "./host";
import { type Answer, useAnswer } from "./use-answer";

/** The keyframes or the motion as files that other tools read, and what they leave out. */
export function ExportDialog({ dialogs, services }: DialogProps) {
  const { document, engine } = useStudio();
  const [scene] = useState(() => services.sceneToShare());
  const [isOnTrial] = useState(services.isOnTrial);
  const keyframes = useAnswer(() => engine.writeKeyframes(scene));
  const frames = `${formatCount(frameCount(scene))} frames at ${scene.frameRate} per second`;
  const isEmpty = document.scene.value.tracks[0]?.agents.length === 0;
  if (isEmpty) {
    return (
      <Frame title="Export" size="small" onClose={dialogs.close}>
        <p class="dialog-text">Draw a formation first: there is nobody to export yet.</p>
        <div class="dialog-answers" />
      </Frame>
    );
  }
  return (
    <Frame
      title="Export"
      size="medium"
      lead={`Save keeps the whole scene; these are for other tools.${isOnTrial ? " They leave out what is shown on trial until you accept it." : ""}`}
      onClose={dialogs.close}
    >
      <ul class="exports">
        <ExportRow
          name="Keyframes, CSV"
          text="A row an agent and keyframe: time, group, x and y in meters."
          size={exportSize(scene, "keyframes")}
          losses={lossesOf(keyframes)}
          write={async () => {
            const { text } = await engine.writeKeyframes(scene);
            services.saveFile("keyframes.csv", text, "text/csv");
          }}
        />
        <ExportRow
          name="Motion, CSV"
          text={`A row a frame and agent: ${frames}.`}
          size={exportSize(scene, "csv")}
          write={async () => services.saveFile("motion.csv", await engine.writeMotion(scene, "csv"), "text/csv")}
        />
        <ExportRow
          name="Motion, JSON"
          text={`Times, and for each the place of every agent: ${frames}.`}
          size={exportSize(scene, "json")}
          unit="places"
          write={async () =>
            services.saveFile("motion.json", await engine.writeMotion(scene, "json"), "application/json")
          }
        />
      </ul>
    </Frame>
  );
}

function lossesOf(keyframes: Answer<{ readonly notes: readonly string[] }>): string {
  if (keyframes.kind === "waiting") return "Looking for what it leaves out …";
  if (keyframes.kind === "refused") return keyframes.problem.what;
  return keyframes.value.notes.join(" ") || "It holds all that this scene says.";
}

interface ExportRowProps {
  readonly name: string;
  readonly text: string;
  readonly size: { readonly rows: number; readonly bytes: number };
  /** What there are so many of. */
  readonly unit?: string;
  /** What the file cannot hold, in words; its place is kept while they are not known: a button that is pressed must not move. */
  readonly losses?: string;
  write(): Promise<void>;
}

function ExportRow({ name, text, size, unit = "rows", losses, write }: ExportRowProps) {
  const [state, setState] = useState<"ready" | "writing" | "written" | { readonly refused: string }>("ready");
  const run = async () => {
    setState("writing");
    try {
      await write();
      setState("written");
    } catch (error) {
      setState({ refused: error instanceof EngineError ? error.problem.what : String(error) });
    }
  };
  return (
    <li class="export-row">
      <div>
        <h3>{name}</h3>
        <p>{text}</p>
        <p class="number">
          {formatCount(size.rows)} {unit}, {bytesWords(size.bytes)}
        </p>
        {losses !== undefined && <p class="export-losses">{losses}</p>}
        <p role="status">
          {state === "writing" && "Writing …"}
          {state === "written" && "Written to your downloads."}
          {typeof state === "object" && <span class="export-refused">{state.refused}</span>}
        </p>
      </div>
      <button
        type="button"
        class="button"
        aria-label={`Download ${name}`}
        aria-disabled={state === "writing"}
        onClick={() => state !== "writing" && void run()}
      >
        <Icon node={Download} size={14} />
        Download
      </button>
    </li>
  );
}
