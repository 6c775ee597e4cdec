"""The same doors, corner and corridor walked by JuPedSim, in an environment of its own that has nothing of Cloner.

Reads what ``behaviour_beside.py`` asks from standard input as JSON, writes what each model found as JSON. LGPL,
and heavy to install (two programs' windows come along), so it is an oracle here and never a part of the product.
"""

import json
import sys
import time
from typing import Any

import jupedsim as jps
from shapely import Polygon, unary_union

MODELS = {
    "collision free speed V2": (
        jps.CollisionFreeSpeedModelV2,
        jps.CollisionFreeSpeedModelV2AgentParameters,
        "desired_speed",
    ),
    "anticipation velocity": (
        jps.AnticipationVelocityModel,
        jps.AnticipationVelocityModelAgentParameters,
        "desired_speed",
    ),
}
STEP_S = 0.05


def walked(model: str, asked: dict[str, Any]) -> dict[str, Any]:
    """Return when each person was done, and CPU seconds."""
    kind, parameters, speed = MODELS[model]
    area = unary_union([Polygon(one) for one in asked["floor"]])
    simulation = jps.Simulation(model=kind(), geometry=area, dt=STEP_S)
    exit_stage = simulation.add_exit_stage(asked["goal"])
    journey = simulation.add_journey(jps.JourneyDescription([exit_stage]))
    refused = 0
    for place, own in zip(asked["places"], asked["speeds"], strict=True):
        try:
            simulation.add_agent(
                parameters(
                    position=tuple(place),
                    journey_id=journey,
                    stage_id=exit_stage,
                    radius=asked["radius"],
                    **{speed: own},
                )
            )
        except RuntimeError:
            refused += 1
    times, begun = [], time.process_time()
    for step in range(int(asked["longest_s"] / STEP_S)):
        before = simulation.agent_count()
        simulation.iterate()
        times += [(step + 1) * STEP_S] * (before - simulation.agent_count())
        if not simulation.agent_count():
            break
    return {"times": times, "refused": refused, "cpu_s": time.process_time() - begun}


if __name__ == "__main__":
    asked = json.load(sys.stdin)
    json.dump({model: [walked(model, one) for one in asked] for model in MODELS}, sys.stdout)
