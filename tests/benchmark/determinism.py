"""The first bundles of every scenario, rendered twice under different circumstances: are the bytes the same?

``python -m tests.benchmark.determinism [--bundles N] [SCENARIO ...]`` renders everything in one worker,
one scenario after the other, so that each but the first comes after an unrelated one; then again by two
workers at a time, every scenario in a process of its own. Exit code 1 if any bytes differ.
"""

from __future__ import annotations

import argparse
import hashlib
import multiprocessing
import sys
import time
from collections.abc import Iterable, Sequence
from contextlib import closing
from itertools import islice

from scenarios.bundled import bundled_names
from scenarios.load import load_scenario
from sim.rendering.choice import probe
from sim.world import Snapshot


def digest_of(job: tuple[str, int]) -> str:
    """Return one SHA-256 over the first bundles of a scenario, seed 0, images and truth."""
    from sim.simulate import simulate

    name, count = job
    scenario = load_scenario(name)
    with closing(simulate(scenario.world, scenario.rig, 0)) as snapshots:
        return content_digest(islice(snapshots, count))


def content_digest(snapshots: Iterable[Snapshot]) -> str:
    """Return one SHA-256 over images, their stamps and the truth."""
    from sim.messages import extrinsics, odometry, serialize

    content = hashlib.sha256()
    for snapshot in snapshots:
        for frame in snapshot.frames:
            content.update(f"{frame.camera} {frame.stamp_ns} {frame.arrival_ns}".encode())
            content.update(frame.image.tobytes())
        content.update(serialize(odometry(snapshot.truth)))
        content.update(serialize(extrinsics(snapshot.truth)))
    return content.hexdigest()


def digests(names: Sequence[str], count: int, workers: int, drives_a_process: int | None) -> list[str]:
    """Return the digests of scenarios, rendered by so many workers at a time."""
    context = multiprocessing.get_context("spawn")  # OpenGL does not survive a fork
    jobs = [(name, count) for name in names]
    with context.Pool(workers, maxtasksperchild=drives_a_process) as pool:
        return pool.map(digest_of, jobs, chunksize=1)


def can_be_drawn(name: str) -> bool:
    """Tell whether this machine has a scenario's renderer, and say so where it has not."""
    renderer = load_scenario(name).world.renderer
    problem = probe(renderer).problem
    if problem:
        print(f"{name:<28} left out, no {renderer} here: {problem}")
    return not problem


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenarios", nargs="*", default=list(bundled_names("scenario")))
    parser.add_argument("--bundles", type=int, default=10)
    arguments = parser.parse_args()
    arguments.scenarios = [name for name in arguments.scenarios if can_be_drawn(name)]
    started_s = time.monotonic()
    in_turn = digests(arguments.scenarios, arguments.bundles, 1, None)
    apart = digests(arguments.scenarios, arguments.bundles, 2, 1)
    differing = [
        name for name, one, other in zip(arguments.scenarios, in_turn, apart, strict=True) if one != other
    ]
    for name, digest in zip(arguments.scenarios, in_turn, strict=True):
        print(f"{name:<28} {digest[:16]}  {'DIFFERS' if name in differing else 'same'}")
    same = len(arguments.scenarios) - len(differing)
    print(f"{same} of {len(arguments.scenarios)} the same, in {time.monotonic() - started_s:.0f} s")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
