"""Record a simulated drive as a ROS 2 bag with its truth.

The bag appears under its name only when it is whole: it is written in a hidden folder beside it, which goes
away whatever happens.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from pathlib import Path

from estimator.errors import InputError
from estimator.rig import Rig
from sim.bag_writer import BagWriter
from sim.simulate import simulate
from sim.world import WorldConfig


def record(
    config: WorldConfig,
    rig: Rig,
    seed: int,
    bag: Path,
    on_bundle: Callable[[int, int], None] = lambda done, total: None,
) -> None:
    """Simulate a drive and write it as a bag.

    Args:
        config: The world.
        rig: Nominal.
        seed: Everything random follows from it.
        bag: The folder to make.
        on_bundle: Called after each bundle with how many are done and how many there will be.

    Raises:
        InputError: The bag exists or cannot be written, or this machine cannot render.
    """
    # closing() frees the renderer at once when writing fails or the user interrupts.
    with _appearing_when_whole(bag) as unfinished, closing(simulate(config, rig, seed)) as snapshots:  # noqa: SIM117
        with BagWriter(unfinished, rig, config.inertial, config.truth) as writer:
            for done, snapshot in enumerate(snapshots, start=1):
                writer.write(snapshot)
                on_bundle(done, snapshot.bundle_count or done)


@contextmanager
def _appearing_when_whole(bag: Path) -> Iterator[Path]:
    """Yield a path of the same name in a hidden folder; rename it to ``bag`` if the block succeeds."""
    if bag.exists():
        raise InputError(f"{bag} exists already; wanted a new folder for the recording")
    workshop = bag.parent / f".{bag.name}.{os.getpid()}.partial"
    try:
        workshop.mkdir(parents=True)
        yield workshop / bag.name
        (workshop / bag.name).rename(bag)
    except OSError as error:
        raise InputError(f"cannot write {bag}: {error.strerror or error}") from error
    finally:
        shutil.rmtree(workshop, ignore_errors=True)
