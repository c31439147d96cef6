import "./dialogs.css";
import type { ProblemDetails, Question } from "./dialogs";
import { Frame } from "./frame";
import type { DialogProps } from "./host";

/** One sentence and its answers, the wanted one first. */
export function QuestionDialog({ request, dialogs }: DialogProps<Question>) {
  const [first, ...rest] = request.choices;
  return (
    <Frame title={request.title} size="small" onClose={dialogs.close}>
      <p class="dialog-text">{request.text}</p>
      <div class="dialog-answers">
        {rest.map((choice) => (
          <button key={choice.label} type="button" class="button" onClick={() => dialogs.answer(choice)}>
            {choice.label}
          </button>
        ))}
        {first && (
          <button type="button" class="button primary" autofocus onClick={() => dialogs.answer(first)}>
            {first.label}
          </button>
        )}
      </div>
    </Frame>
  );
}

/** All that is known of what went wrong. */
export function ProblemDialog({ request, dialogs }: DialogProps<ProblemDetails>) {
  return (
    <Frame title={request.title} size="small" onClose={dialogs.close}>
      <p class="dialog-text">{request.text}</p>
      {request.details.length > 0 && (
        <ul class="dialog-details">
          {request.details.map((detail) => (
            <li key={detail}>{detail}</li>
          ))}
        </ul>
      )}
      <div class="dialog-answers">
        <button type="button" class="button primary" autofocus onClick={dialogs.close}>
          Close
        </button>
      </div>
    </Frame>
  );
}
