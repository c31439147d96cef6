import type { RefObject } from "preact";
import { useEffect, useState } from "preact/hooks";
import type { Preview } from "./services";
import { type Answer, problemOf } from "./use-answer";

/** What is about to be scrolled into sight is loaded, too. */
const AHEAD = "300px";

/** An example's preview, asked for once its picture comes into sight: the gallery is long, a phone's line thin. */
export function usePreview(picture: RefObject<Element>, ask: () => Promise<Preview>): Answer<Preview> {
  const [answer, setAnswer] = useState<Answer<Preview>>({ kind: "waiting" });
  useEffect(() => {
    if (!picture.current) return;
    let isWanted = true;
    const sight = new IntersectionObserver(
      (entries) => {
        if (!entries.some((entry) => entry.isIntersecting)) return;
        sight.disconnect();
        ask().then(
          (value) => isWanted && setAnswer({ kind: "here", value }),
          (error: unknown) => isWanted && setAnswer({ kind: "refused", problem: problemOf(error) }),
        );
      },
      { rootMargin: AHEAD },
    );
    sight.observe(picture.current);
    return () => {
      isWanted = false;
      sight.disconnect();
    };
  }, []);
  return answer;
}
