"""The recording of a scenario and seed: from the cache, or rendered into it."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from scenarios.cache import RecordingCache
from scenarios.digest import recording_digest
from scenarios.scenario import Scenario

FINGERPRINT = "fingerprint.json"  # beside the bag's own files: what the pictures depend on besides the digest
OnBundle = Callable[[int, int], None]


@contextmanager
def cached_recording(scenario: Scenario, seed: int, on_bundle: OnBundle) -> Iterator[Path]:
    """Yield the bag of a scenario and seed; ``on_bundle(i, n)`` is called only if it must be rendered."""

    def render(bag: Path) -> None:
        # These load the graphics library, which a cached recording does not need.
        from sim.fingerprint import fingerprint
        from sim.recorder import record

        on_bundle(0, scenario.world.drive.bundle_count)  # the street is built first, which takes seconds
        record(scenario.world, scenario.rig, seed, bag, on_bundle)
        (bag / FINGERPRINT).write_text(json.dumps(fingerprint(scenario.world.renderer), indent=1))

    with RecordingCache.of_user().recording(recording_digest(scenario, seed), render) as bag:
        yield bag


def fingerprint_of(bag: Path) -> dict[str, str] | None:
    """Return what rendered a bag; None for one that says nothing of it."""
    try:
        return dict(json.loads((bag / FINGERPRINT).read_text()))
    except (OSError, ValueError):
        return None
