import "./dialogs.css";
import "./help.css";
import type { Action, ActionSection } from "../actions";
import { useStudio } from "../studio";
import { keyName } from "../use-action";
import { Frame } from "./frame";
import type { DialogProps } from "./host";
import { TourStep } from "./tour-step";

/** What the pointer does with a key held, which no button says. */
const GESTURES: readonly (readonly [keys: string, words: string])[] = [
  ["Space + drag", "Pan; the middle button does, too"],
  ["Wheel", "Zoom to the pointer; on the timeline it scrolls"],
  ["Shift + drag", "On the ruler: mark the range that loops"],
  ["Alt + drag", "On a keyframe: move all later ones along"],
  ["Alt + ← →", "On a keyframe: earlier or later in the order"],
];

/** How it works in four steps, and every key from the one table of actions. */
export function HelpDialog({ dialogs }: DialogProps) {
  const { actions } = useStudio();
  return (
    <Frame title="How it works" size="large" onClose={dialogs.close}>
      <ol class="tour">
        <TourStep picture="draw" title="Draw a formation" text="Pull a curve across the stage, or place a shape." />
        <TourStep picture="next" title="Add a keyframe, draw the next" text="The same agents take the new places." />
        <TourStep picture="ties" title="Say who belongs together" text="Ties and groups keep neighbors side by side." />
        <TourStep picture="play" title="Play and share" text="Amber is tight, red is a clash. One link holds it all." />
      </ol>
      <div class="shortcuts">
        {sectionsOf(actions.all).map(([section, listed]) => (
          <section key={section} aria-label={section}>
            <h3>{section}</h3>
            <dl>
              {listed.map((action) => (
                <div key={action.id}>
                  <dt>{action.label}</dt>
                  <dd>
                    <Keys keys={keyName(action.keys[0] ?? "")} />
                  </dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
        <section aria-label="With the pointer">
          <h3>With the pointer</h3>
          <dl>
            {GESTURES.map(([keys, words]) => (
              <div key={keys}>
                <dt>{words}</dt>
                <dd>
                  <Keys keys={keyName(keys)} />
                </dd>
              </div>
            ))}
          </dl>
        </section>
      </div>
    </Frame>
  );
}

function Keys({ keys }: { keys: string }) {
  return (
    <>
      {keys.split(/(?<=.)\+(?=.)/).map((key) => (
        <kbd key={key} class="key">
          {key.trim()}
        </kbd>
      ))}
    </>
  );
}

/** Only what has a key; the palette lists the rest. */
function sectionsOf(all: readonly Action[]): [ActionSection, Action[]][] {
  const sections = new Map<ActionSection, Action[]>();
  for (const action of all) {
    if (action.keys.length > 0) sections.set(action.section, [...(sections.get(action.section) ?? []), action]);
  }
  return [...sections];
}
