import { Check, CircleQuestionMark, type IconNode, TriangleAlert, X } from "lucide";
import { useEffect, useRef } from "preact/hooks";
import { Icon } from "../../theme/icons";
import type { Message } from "../messages";
import { useStudio } from "../studio";

/** Good news needs no answer and goes by itself; milliseconds. */
const GOOD_NEWS_STAYS = 6000;

const ICONS: Readonly<Record<Message["tone"], IconNode>> = {
  good: Check,
  problem: TriangleAlert,
  question: CircleQuestionMark,
};

/** One message, its actions and the way to be rid of it. */
export function Toast({ message }: { message: Message }) {
  const { messages } = useStudio();
  const { id, tone } = message;
  const element = useRef<HTMLDivElement>(null);
  const isPassing = tone === "good" && message.actions.length === 0;

  useEffect(() => {
    if (!isPassing) return;
    const leave = () => {
      // Whoever is reading or reaching for it keeps it.
      if (element.current?.matches(":hover, :focus-within")) timer = setTimeout(leave, GOOD_NEWS_STAYS / 3);
      else messages.dismiss(id);
    };
    let timer = setTimeout(leave, GOOD_NEWS_STAYS);
    return () => clearTimeout(timer);
  }, [isPassing, id, messages]);

  return (
    <div ref={element} class={`toast ${tone}`}>
      <Icon node={ICONS[tone]} />
      <p>
        <strong>{message.title}</strong> {message.text}
      </p>
      {message.actions.map((action) => (
        <button
          key={action.label}
          type="button"
          class="button soft"
          onClick={() => {
            messages.dismiss(id);
            action.run();
          }}
        >
          {action.label}
        </button>
      ))}
      <button type="button" class="icon-button" aria-label="Dismiss" onClick={() => messages.dismiss(id)}>
        <Icon node={X} />
      </button>
    </div>
  );
}
