// What says that a part did not come is here before that.
import "./panels/stage-edge/toast";
import { attachDrop } from "./files/drop";
import type { Intake, IntakeParts } from "./files/intake";
import type { Actions } from "./panels/actions";
import { type AgentClipboard, attachClipboard } from "./panels/clipboard-events";
import { attachKeyboard } from "./panels/keyboard";
import { NOT_LOADED } from "./panels/messages";
import type { View } from "./stage/view";
import { attachTools } from "./tools/attach-tools";
import type { ToolboxAtWork } from "./tools/create-toolbox";

export interface HandsParts {
  readonly stageHost: HTMLElement;
  readonly toolbox: ToolboxAtWork;
  readonly view: View;
  readonly actions: Actions;
  readonly clipboard: AgentClipboard;
  readonly intake: IntakeParts;
  typeAhead(key: string): boolean;
}

const isMac = /Mac|iPhone|iPad/.test(navigator.userAgent);

/** Lets pointer, keys, clipboard and drops in. Fetched as soon as the page is drawn: nobody acts on what they do not see. */
export function attachHands({ stageHost, toolbox, view, actions, clipboard, ...parts }: HandsParts): void {
  const takeIn = (take: (intake: Intake) => Promise<boolean>): void => {
    import("./files/intake").then(
      ({ createIntake }) => void take(createIntake(parts.intake)),
      () => parts.intake.messages.say(NOT_LOADED),
    );
  };
  attachTools(stageHost, toolbox, view, isMac);
  const { holdSpace, releaseSpace } = toolbox;
  attachKeyboard(window, { actions, isMac, holdSpace, releaseSpace, typeAhead: parts.typeAhead });
  attachClipboard(document, clipboard, (file) => takeIn((intake) => intake.openFile(file)));
  attachDrop(
    document.documentElement,
    (files) => takeIn((intake) => intake.openFiles(files)),
    (text) => takeIn((intake) => intake.openText(text, "What you dropped")),
  );
}
