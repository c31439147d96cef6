"""Times JuPedSim's social force on the bench's marching blocks.

Prints JSON: milliseconds of processor time for 300 steps, one entry a run.
"""

import json
import math
import time

import jupedsim

STEPS = 300

# Its own: at 1/30 s its forces throw agents out of the floor.
STEP = 0.01


def marching(agent_count):
    """A block a meter apart that is to turn upside down while it moves on, as the bench's crowds."""
    columns = math.ceil(math.sqrt(agent_count))
    walls = [(-60, -60), (columns + 80, -60), (columns + 80, columns + 60), (-60, columns + 60)]
    simulation = jupedsim.Simulation(model=jupedsim.SocialForceModel(), geometry=walls, dt=STEP)
    stage = simulation.add_direct_steering_stage()
    journey = simulation.add_journey(jupedsim.JourneyDescription([stage]))
    for k in range(agent_count):
        x, y = k % columns, k // columns
        told = jupedsim.SocialForceModelAgentParameters(
            position=(x, y), journey_id=journey, stage_id=stage, desired_speed=2.0, reaction_time=0.5, radius=0.25
        )
        agent = simulation.add_agent(told)
        simulation.agent(agent).target = (x + 20, columns - y)
    return simulation


def runs(agent_count, count):
    times = []
    for _ in range(count):
        simulation = marching(agent_count)
        start = time.process_time()
        simulation.iterate(STEPS)
        times.append((time.process_time() - start) * 1000)
    return times


rows = {}
for agent_count, count in ((110, 3), (306, 3), (783, 1), (1190, 1), (1936, 1), (10000, 1)):
    rows[f"crowd of {agent_count}, {STEPS} steps"] = runs(agent_count, count)
print(json.dumps(rows))
