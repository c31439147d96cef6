import { keyframeLabel } from "../../document/queries";
import type { Run } from "../../document/run";
import { mainTrack } from "../../document/scene";
import { formatDuration } from "../../document/units";
import { WordAction } from "../action-button";
import { Row } from "../controls/row";
import { useStudio } from "../studio";
import { Head } from "./head";
import { Section } from "./section";

/** Several keyframes in a row: what is done with all of them. */
export function RunPanel({ run }: { run: Run }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const { keyframes } = mainTrack(scene);
  const [first, last] = [keyframes[run.first], keyframes[run.last]];
  if (!first || !last) return null;
  return (
    <>
      <Head kind="Keyframes" aside={<span class="number">{`${run.last - run.first + 1} of ${keyframes.length}`}</span>}>
        <span class="ellipsis">{keyframeLabel(scene, run.first)}</span>
        <span class="arrow">→</span>
        <span class="ellipsis">{keyframeLabel(scene, run.last)}</span>
      </Head>
      <Section>
        <Row label="Lasts">
          <span class="row-value number">{formatDuration(last.time + last.hold - first.time)}</span>
        </Row>
        <div class="inspector-buttons">
          <WordAction id="reverse-run" class="button">
            Reverse run
          </WordAction>
          <WordAction id="repeat-run" class="button">
            Repeat run
          </WordAction>
        </div>
      </Section>
    </>
  );
}
