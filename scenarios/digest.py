"""One number for everything that changes a recording: world, rig, seed and the version of the simulator."""

from __future__ import annotations

import hashlib
import json

from estimator.rig_file import rig_to_yaml
from scenarios.scenario import Scenario
from sim.world import WORLD_VERSION


def recording_digest(scenario: Scenario, seed: int) -> str:
    """Return 64 hexadecimal digits; the scenario's name and ``about`` do not change them."""
    content = {
        "rig": rig_to_yaml(scenario.rig),
        "seed": seed,
        "world": scenario.world.model_dump(mode="json"),
        "world_version": WORLD_VERSION,
    }
    text = json.dumps(content, sort_keys=True, allow_nan=False)
    return hashlib.sha256(text.encode()).hexdigest()
