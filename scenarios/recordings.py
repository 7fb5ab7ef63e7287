"""The recording of a scenario and seed: from the cache, or rendered into it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from scenarios.cache import RecordingCache
from scenarios.digest import recording_digest
from scenarios.scenario import Scenario

OnBundle = Callable[[int, int], None]


@contextmanager
def cached_recording(scenario: Scenario, seed: int, on_bundle: OnBundle) -> Iterator[Path]:
    """Yield the bag of a scenario and seed; ``on_bundle(i, n)`` is called only if it must be rendered."""

    def render(bag: Path) -> None:
        from sim.recorder import record  # loads the graphics library, which a cached recording does not need

        on_bundle(0, scenario.world.drive.bundle_count)  # the street is built first, which takes seconds
        record(scenario.world, scenario.rig, seed, bag, on_bundle)

    with RecordingCache.of_user().recording(recording_digest(scenario, seed), render) as bag:
        yield bag
