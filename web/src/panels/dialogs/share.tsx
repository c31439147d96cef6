import "./dialogs.css";
import "./share.css";
import { Lock } from "lucide";
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import { keyframeLabel } from "../../document/queries";
import type { Scene } from "../../document/scene";
import { formatCount } from "../../document/units";
import type { LinkReport } from "../../engine/api";
import { Icon } from "../../theme/icons";
import { useStudio } from "../studio";
import { Frame, focusLate } from "./frame";
import type { DialogProps } from "./host";
import { LinkMeter } from "./link-meter";
import { NOT_ACCEPTED } from "./services";
import { brokenWords, fitWords, roundingWords, savingWords } from "./share-words";
import { useAnswer } from "./use-answer";

/** The whole scene in one link: how long it is, where it fits, and what shortening it costs. */
export function ShareDialog({ services, dialogs }: DialogProps) {
  const { engine, document } = useStudio();
  const [scene] = useState(() => services.sceneToShare());
  const [isOnTrial] = useState(services.isOnTrial);
  const exact = useAnswer(() => engine.link(scene, "exact"));
  const short = useAnswer(() => engine.link(scene, "short"));
  const [isShort, setShort] = useState(false);
  const title = document.scene.value.title;
  const wanted = isShort ? short : exact;

  return (
    <Frame
      title={title ? `Share “${title}”` : "Share this scene"}
      size="medium"
      lead={`Whoever opens the link gets a copy of the scene that they can edit.${isOnTrial ? ` ${NOT_ACCEPTED}` : ""}`}
      onClose={dialogs.close}
    >
      {wanted.kind === "here" ? (
        <>
          <LinkRow link={services.address + wanted.value.fragment} />
          <Length characters={services.address.length + wanted.value.fragment.length} />
          {exact.kind === "here" && short.kind === "here" && (
            <ShorterRow
              saving={savingWords(
                services.address.length + exact.value.fragment.length,
                services.address.length + short.value.fragment.length,
              )}
              isShort={isShort}
              onToggle={setShort}
            />
          )}
          <Cost report={wanted.value} scene={scene} />
        </>
      ) : (
        <p class="dialog-text" role="status">
          {wanted.kind === "waiting" ? "Writing the link …" : wanted.problem.what}
        </p>
      )}
    </Frame>
  );
}

function LinkRow({ link }: { link: string }) {
  const { messages } = useStudio();
  const field = useRef<HTMLInputElement>(null);
  const button = useRef<HTMLButtonElement>(null);
  const [copied, setCopied] = useState<"no" | "yes" | "refused">("no");
  useLayoutEffect(() => {
    focusLate(button.current);
  }, []);
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(link);
      setCopied("yes");
      messages.announce(`Link copied. ${formatCount(link.length)} characters`);
    } catch {
      // No permission, or no secure context: the person can still copy what is selected.
      field.current?.select();
      setCopied("refused");
    }
  };
  return (
    <div class="link-row">
      <input
        ref={field}
        class="link-field"
        aria-label="Link"
        readOnly
        spellcheck={false}
        value={link}
        onFocus={(event) => event.currentTarget.select()}
      />
      <button ref={button} type="button" class="button primary" onClick={copy}>
        Copy link
      </button>
      <p class="link-note" role="status">
        {copied === "yes" && "Copied."}
        {copied === "refused" && "The browser did not allow copying. The link is selected: press Ctrl+C or Cmd+C."}
      </p>
    </div>
  );
}

function Length({ characters }: { characters: number }) {
  return (
    <>
      <p class="link-length">
        <strong class="number">{formatCount(characters)}</strong> characters. {fitWords(characters)}
      </p>
      <LinkMeter characters={characters} />
    </>
  );
}

interface ShorterRowProps {
  readonly saving: string | null;
  readonly isShort: boolean;
  onToggle(isShort: boolean): void;
}

/** Absent where rounding would save little. */
function ShorterRow({ saving, isShort, onToggle }: ShorterRowProps) {
  if (!saving) return null;
  return (
    <label class="option-row">
      <span>
        Shorter link <small>{saving}</small>
      </span>
      <input
        type="checkbox"
        class="switch"
        aria-label="Shorter link"
        checked={isShort}
        onChange={(event) => onToggle(event.currentTarget.checked)}
      />
    </label>
  );
}

function Cost({ report, scene }: { report: LinkReport; scene: Scene }) {
  const names = report.brokenKeyframes.map((index) => keyframeLabel(scene, index));
  const broken = brokenWords(names, scene.minimumDistance, scene.stage.units);
  return (
    <>
      {broken && <p class="dialog-warning">{broken}</p>}
      <p class="link-privacy">
        <Icon node={Lock} size={14} />
        <span>
          The scene travels inside the link, after the #. No server receives it. {roundingWords(report.rounding)}
        </span>
      </p>
    </>
  );
}
