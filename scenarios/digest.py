"""One number for everything that changes a recording: world, rig, seed and the code that makes it."""

from __future__ import annotations

import hashlib
import json
from functools import cache

from estimator.rig_file import rig_to_yaml
from scenarios.scenario import Scenario
from scenarios.source_digest import source_digest


def recording_digest(scenario: Scenario, seed: int) -> str:
    """Return 64 hexadecimal digits; the scenario's name and ``about`` do not change them."""
    content = {
        "rig": rig_to_yaml(scenario.rig),
        "seed": seed,
        "source": _source(),
        "world": scenario.world.model_dump(mode="json"),
    }
    text = json.dumps(content, sort_keys=True, allow_nan=False)
    return hashlib.sha256(text.encode()).hexdigest()


@cache
def _source() -> str:
    """Hash the sources once: they are what this process runs, whatever becomes of the files later."""
    return source_digest()
