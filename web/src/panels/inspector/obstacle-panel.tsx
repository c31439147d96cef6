import { tiesTo, tieToObstacle, untieFromObstacle } from "../../document/commands/obstacle-ties";
import { deleteObstacle, isOutline, renameObstacle, setObstacleShape } from "../../document/commands/obstacles";
import { WHOLE_SCENE } from "../../document/commands/ties";
import type { Point } from "../../document/formation";
import { middleOf, obstacleLabel, shapeMoved } from "../../document/obstacle";
import { agentLabel } from "../../document/queries";
import type { ObstacleShape } from "../../document/scene";
import type { Command } from "../../document/store";
import { metersPer } from "../../document/units";
import { NumberBox } from "../controls/number-box";
import { QuantityRow } from "../controls/quantity-row";
import { Row } from "../controls/row";
import { useStudio } from "../studio";
import { Head } from "./head";
import { NameRow } from "./name-row";
import { PlaceBoxes } from "./place-boxes";
import { FACTOR, isLongUnit, sizeQuantity } from "./quantities";
import { Section } from "./section";

const NO_OUTLINE = "Its sides would cross, or go around nothing, or lie too far away.";

/** Something to go around: its name, where it is and how large, to the number. */
export function ObstaclePanel({ index }: { index: number }) {
  const { document, messages } = useStudio();
  const scene = document.scene.value;
  const obstacle = scene.obstacles[index];
  if (!obstacle) return null;
  const { shape } = obstacle;
  const { units } = scene.stage;
  const set = (changed: ObstacleShape) => {
    if (isOutline(changed)) document.perform(setObstacleShape(index, changed));
    else messages.say({ tone: "problem", title: "The obstacle stays as it was.", text: NO_OUTLINE });
  };
  const [x, y] = middleOf(shape);
  return (
    <>
      <Head kind="Obstacle" aside={<span class="number">{`${index + 1} of ${scene.obstacles.length}`}</span>}>
        <span class="ellipsis">{obstacleLabel(scene, index)}</span>
      </Head>
      <Section>
        <NameRow
          key={index}
          name={obstacle.name}
          label={obstacleLabel(scene, index)}
          onCommit={(name) => document.perform(renameObstacle(index, name))}
        />
        <PlaceRow
          label={shape.kind === "circle" ? "Center" : "Middle"}
          at={[x, y]}
          onCommit={(to) => set(shapeMoved(shape, [to[0] - x, to[1] - y]))}
        />
        {shape.kind === "circle" ? (
          <Row label="Radius" {...(isLongUnit(units) ? { note: units } : {})}>
            <NumberBox
              label="Radius"
              value={shape.radius / metersPer(units)}
              quantity={{ ...sizeQuantity(units), min: 0.01 }}
              isUnitBeside={isLongUnit(units)}
              onCommit={(radius) => set({ ...shape, radius: radius * metersPer(units) })}
            />
          </Row>
        ) : (
          shape.points.map((point, corner) => (
            <PlaceRow
              key={corner}
              label={`Corner ${corner + 1}`}
              at={point}
              onCommit={(to) => set({ ...shape, points: shape.points.with(corner, to) })}
            />
          ))
        )}
        <div class="inspector-buttons">
          <button type="button" class="button" onClick={() => document.perform(deleteObstacle(index))}>
            Delete <span class="key">Del</span>
          </button>
        </div>
      </Section>
      <TiedAgents index={index} />
    </>
  );
}

/** Who keeps their clearance to it, and how firmly. */
function TiedAgents({ index }: { index: number }) {
  const { document } = useStudio();
  const scene = document.scene.value;
  const ties = tiesTo(scene, index);
  if (ties.length === 0) return null;
  return (
    <Section title="Tied to it">
      {ties.map(([agent, factor]) => (
        <QuantityRow
          key={agent}
          label={`Weight of ${agentLabel(scene, agent)}`}
          shortLabel={agentLabel(scene, agent)}
          value={factor}
          quantity={FACTOR}
          tick={1}
          command={(value) => tieToObstacle(WHOLE_SCENE, agent, index, value)}
        />
      ))}
      <div class="inspector-buttons">
        <button type="button" class="button" onClick={() => document.perform(untieAll(index))}>
          Untie
        </button>
      </div>
    </Section>
  );
}

function untieAll(index: number): Command {
  return {
    label: "Untie from the obstacle",
    apply: (scene) =>
      tiesTo(scene, index).reduce((was, [agent]) => untieFromObstacle(WHOLE_SCENE, agent, index).apply(was), scene),
  };
}

function PlaceRow({ label, at, onCommit }: { label: string; at: Point; onCommit(to: Point): void }) {
  const { units } = useStudio().document.scene.value.stage;
  return (
    <Row label={label} {...(isLongUnit(units) ? { note: units } : {})}>
      <PlaceBoxes of={label} at={at} units={units} onCommit={onCommit} />
    </Row>
  );
}
