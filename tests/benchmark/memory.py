"""Does a long drive record in constant memory? Prints the process's resident size as the drive goes on.

``python -m tests.benchmark.memory [SCENARIO] [--minutes 10] [--set KEY=VALUE ...]`` drives round and round
at one bundle a second in a quarter of the resolution: physics, street and traffic are those of a long drive.
Exit code 1 if the size grows by more than a tenth between the first minute and the last.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

import psutil

from scenarios.load import load_scenario
from sim.recorder import record
from tests.scenarios.first_bundles import shrunk

_MOST_GROWTH = 1.1


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenario", nargs="?", default="block_loop")
    parser.add_argument("--minutes", type=int, default=10)
    parser.add_argument("--set", dest="settings", action="append", default=[])
    arguments = parser.parse_args()
    speed_mps = load_scenario(arguments.scenario).world.drive.speed_mps
    distance_m = speed_mps * 60 * arguments.minutes
    settings = ["drive.rate_hz=1", f"drive.distance_m={distance_m}", *arguments.settings]
    scenario = shrunk(load_scenario(arguments.scenario, settings))
    a_minute = round(60 * scenario.world.drive.rate_hz)
    process = psutil.Process()
    sizes_mb: list[float] = []

    def measure(done: int, total: int) -> None:
        if done % a_minute == 0:
            sizes_mb.append(process.memory_info().rss / 1e6)
            print(f"minute {done // a_minute:>3}: {sizes_mb[-1]:7.0f} MB", flush=True)

    with tempfile.TemporaryDirectory() as folder:
        record(scenario.world, scenario.rig, 0, Path(folder) / "bag", measure)
    growth = sizes_mb[-1] / sizes_mb[0]
    print(f"from minute 1 to minute {len(sizes_mb)}: times {growth:.3f}")
    return 0 if growth <= _MOST_GROWTH else 1


if __name__ == "__main__":
    sys.exit(main())
