"""Do the bundled streets look like real ones to a feature tracker?

``python -m tests.benchmark.likeness [SCENARIO ...] [--seeds 0,1,2] [--set KEY=VALUE ...] [--images FOLDER]``
drives with the forward camera alone, without sensor noise, takes a frame a metre of the whole drive (of a
closed route once round) and prints the statistics of ``rigtrue likeness``: mean, and 10th to 90th percentile
of the frames, each marked where it leaves the real drives' range. With ``--video`` the frames are as far
apart in time as a metre takes at cruising speed, as a real camera takes them, so they lie closer where the
car slows down. Exit code 1 if any mean is outside.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np

from estimator.bundle import Image
from estimator.se3 import Array
from eval.likeness import Likeness, compare_with_real
from eval.likeness_statistics import statistics_of
from scenarios.load import load_scenario
from sim.light.on_board import OnBoardAtmosphere
from sim.rendering.choice import open_renderer
from sim.scene import build_scene
from sim.sensing.capture import CameraArray
from sim.stage import Stage
from sim.vehicle.plan import SpeedPlan
from sim.vehicle.route import Route

PLAIN_URBAN = (
    "straight_road",
    "first_drive",
    "urban_bend",
    "crossroads",
    "t_junction",
    "block_loop",
    "roundabout",
)
_ROWS = slice(81, 320)  # without sky and the car's own bonnet, as the real drives were measured
_SPACING_M = 1.0
_LOOKS_S = 0.01


def frames_of(name: str, seed: int, settings: Sequence[str], as_video: bool = False) -> Iterator[Image]:
    """Yield what the reference camera sees at every metre of a scenario, exposed but without noise.

    Args:
        name: Of the scenario.
        seed: Draws its world.
        settings: ``dotted.path=value`` texts on top of the scenario.
        as_video: Frames are evenly apart in time instead: the time of a metre at cruising speed.
    """
    scenario = load_scenario(name, [*settings, "sensor.noise=0"])
    world, rig = scenario.world, scenario.rig
    rig = replace(rig, cameras={rig.reference: rig[rig.reference]})
    scene = build_scene(world, rig, seed)
    stage = Stage(scene, world.drive)
    air = None if scene.atmosphere is None else OnBoardAtmosphere(scene.atmosphere, scene.model, stage.at)
    camera = CameraArray(scene.lenses, world.sensor, seed, air)
    until_s, each_metre_s = _each_metre_s(stage.plan, scene.route)
    even_s = np.arange(0.0, until_s, _SPACING_M / world.drive.speed_mps)
    times_s = even_s if as_video else each_metre_s
    with open_renderer(world.renderer, scene.model) as renderer:
        for index, time_s in enumerate(times_s):
            yield camera.take(stage, renderer, index, time_s)[rig.reference]


def _each_metre_s(plan: SpeedPlan, route: Route) -> tuple[float, Array]:
    """Return when the drive, or its first lap, ends, and when the car is another metre on."""
    times_s = np.arange(0.0, plan.duration_s, _LOOKS_S)
    driven_m = np.array([plan.distance_m(time_s) for time_s in times_s])
    end_m = min(driven_m[-1], route.length_m if route.closed else np.inf)
    metres = times_s[np.searchsorted(driven_m, np.arange(0.0, end_m, _SPACING_M))]
    return float(times_s[np.searchsorted(driven_m, end_m)]), metres


def _cell(one: Likeness) -> str:
    """Mean and spread; ``!`` behind what lies outside of the range wanted."""
    low, high = one.wanted
    text = f"{_number(one.mean)}{'' if one.inside else '!'}"
    low_mark, high_mark = "" if one.low >= low else "!", "" if one.high <= high else "!"
    return f"{text} ({_number(one.low)}{low_mark} to {_number(one.high)}{high_mark})"


def _number(value: float) -> str:
    return f"{value:.0f}" if abs(value) >= 20 else f"{value:.2f}"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenarios", nargs="*", default=PLAIN_URBAN)
    parser.add_argument("--seeds", default="0,1,2")
    parser.add_argument("--set", dest="settings", action="append", default=[])
    parser.add_argument("--video", action="store_true", help="frames evenly apart in time")
    parser.add_argument("--images", type=Path, help="folder to write every frame to")
    arguments = parser.parse_args()
    outside = 0
    for scenario in arguments.scenarios:
        for seed in map(int, arguments.seeds.split(",")):
            frames = list(frames_of(scenario, seed, arguments.settings, arguments.video))
            if arguments.images is not None:
                _write(arguments.images, f"{scenario}_{seed}", frames)
            results = compare_with_real(statistics_of([frame[_ROWS] for frame in frames]))
            outside += sum(not one.inside for one in results)
            cells = (f"{one.name.removesuffix('_per_100kpx')} {_cell(one)}" for one in results)
            print(f"{scenario} {seed}: " + "; ".join(cells), flush=True)
    return 1 if outside else 0


def _write(folder: Path, name: str, frames: Sequence[Image]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for index, frame in enumerate(frames):
        cv2.imwrite(str(folder / f"{name}_{index:03d}.png"), frame)


if __name__ == "__main__":
    sys.exit(main())
