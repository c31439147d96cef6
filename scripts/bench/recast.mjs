// Lets Recast's crowd go in the browser like the bench's marching blocks.
import { Crowd, init } from "@recast-navigation/core";
import { generateSoloNavMesh } from "@recast-navigation/generators";

const TOLD = {
  radius: 0.25,
  height: 1.8,
  maxAcceleration: 8,
  maxSpeed: 5,
  collisionQueryRange: 3,
  separationWeight: 2,
};

/** A floor that is larger than everything, two triangles. */
function floor(side) {
  const [low, high] = [-60, side + 80];
  const corners = [low, 0, low, low, 0, high, high, 0, high, high, 0, low];
  const { success, navMesh } = generateSoloNavMesh(corners, [0, 1, 2, 0, 2, 3], {
    cs: 0.5,
    ch: 0.2,
    walkableHeight: 2,
  });
  if (!success) throw new Error("Recast made no floor");
  return navMesh;
}

let crowd = null;

export const begin = init;

/** A block a meter apart that is to turn upside down while it moves on: x is x, z is y. */
export function stand(agentCount) {
  const columns = Math.ceil(Math.sqrt(agentCount));
  crowd = new Crowd(floor(columns), { maxAgents: agentCount, maxAgentRadius: 0.25 });
  for (let k = 0; k < agentCount; k += 1) {
    const [x, y] = [k % columns, Math.floor(k / columns)];
    crowd.addAgent({ x, y: 0, z: y }, TOLD).requestMoveTarget({ x: x + 20, y: 0, z: columns - y });
  }
}

export function go(stepCount) {
  for (let step = 0; step < stepCount; step += 1) crowd.update(1 / 30);
  if (crowd.getAgents()[0].position().x < 1) throw new Error("Recast's agents do not go");
}
