import { Component, type ComponentChildren } from "preact";

interface SafelyProps {
  readonly children: ComponentChildren;
  /** What stands in the place of what failed; by default a sentence and a button. */
  instead?(again: () => void): ComponentChildren;
}

/** What went wrong while a panel was drawn stays within it, is said, and is reported to the browser. */
export class Safely extends Component<SafelyProps, { readonly hasFailed: boolean }> {
  override state = { hasFailed: false };

  override componentDidCatch(error: unknown): void {
    reportError(error);
    this.setState({ hasFailed: true });
  }

  override render({ children, instead = Sentence }: SafelyProps): ComponentChildren {
    return this.state.hasFailed ? instead(() => this.setState({ hasFailed: false })) : children;
  }
}

export const WENT_WRONG = "Something went wrong here.";
export const IS_SAFE = "Your scene is safe.";

function Sentence(again: () => void): ComponentChildren {
  return (
    <div class="went-wrong" role="alert">
      <p>
        {WENT_WRONG} {IS_SAFE}
      </p>
      <button type="button" class="button" onClick={again}>
        Try again
      </button>
    </div>
  );
}
