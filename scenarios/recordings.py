"""The recording of a scenario and seed: from the cache, or rendered into it.

Another driver, processor or package draws other pictures, so what one machine has rendered answers for no
other one that shares the cache, nor for the same one after an update. Only where a machine cannot render at
all does what another one has rendered answer.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from scenarios.cache import RecordingCache
from scenarios.digest import recording_digest
from scenarios.scenario import Scenario

FINGERPRINT = "fingerprint.json"  # beside the bag's own files: what the pictures depend on besides the digest
OnBundle = Callable[[int, int], None]


@contextmanager
def cached_recording(scenario: Scenario, seed: int, on_bundle: OnBundle) -> Iterator[Path]:
    """Yield the bag of a scenario and seed; ``on_bundle(i, n)`` is called only if it must be rendered.

    Raises:
        InputError: It must be rendered and this machine cannot.
    """
    # These load the graphics library, which those who only list scenarios do not need.
    from sim.fingerprint import fingerprint
    from sim.recorder import record
    from sim.rendering.choice import probe, require_renderer

    machine = fingerprint(scenario.world.renderer)
    digest = recording_digest(scenario, seed)
    cache = RecordingCache.of_user()

    def render(bag: Path) -> None:
        require_renderer(scenario.world.renderer)
        on_bundle(0, scenario.world.drive.bundle_count)  # the street is built first, which takes seconds
        record(scenario.world, scenario.rig, seed, bag, on_bundle)
        (bag / FINGERPRINT).write_text(json.dumps(machine, indent=1))

    name = recording_name(digest, machine)
    if probe(scenario.world.renderer).problem is not None:
        name = cache.newest(f"{digest}-") or name
    with cache.recording(name, render) as bag:
        yield bag


def is_recorded(digest: str) -> bool:
    """Tell whether the cache has a recording of a digest, whoever rendered it."""
    return RecordingCache.of_user().newest(f"{digest}-") is not None


def recording_name(digest: str, machine: Mapping[str, str]) -> str:
    """Return what the cache calls the recording of a digest that a machine has rendered."""
    maker = hashlib.sha256(json.dumps(dict(machine), sort_keys=True).encode()).hexdigest()
    return f"{digest}-{maker[:16]}"


def fingerprint_of(bag: Path) -> dict[str, str] | None:
    """Return what rendered a bag; None for one that says nothing of it."""
    try:
        return dict(json.loads((bag / FINGERPRINT).read_text()))
    except (OSError, ValueError):
        return None
