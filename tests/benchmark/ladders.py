"""Do the severities lead one way? Every effect's ladder, measured on frames of one camera.

``python -m tests.benchmark.ladders [EFFECT ...] [--sheet FILE.jpg]`` drives down one street at 10 m/s
without sensor noise, takes a frame every metre with the pinhole camera ``front`` at every severity, and
prints what the statistics of ``eval.likeness_statistics`` make of them. After a row, ``<`` says that it must
rise and does, ``>`` that it must fall and does, ``REVERSES`` that a step goes the other way, and ``-`` that
nothing is asked of it. Ends with status 1 if anything reverses.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Sequence
from itertools import pairwise
from pathlib import Path

import cv2
import numpy as np

from estimator.bundle import Image
from eval.likeness_statistics import statistics_of
from scenarios.load import load_scenario
from sim.light.on_board import OnBoardAtmosphere
from sim.rendering.classic import ClassicRenderer
from sim.scene import Scene, build_scene
from sim.sensing.capture import CameraArray
from sim.stage import Stage
from sim.world import WorldConfig
from tests.benchmark.ladder_effects import EFFECTS, Effect

CAMERA, FRAMES, PERIOD_S = "front", 12, 0.1
PLAIN = ("drive.speed_mps=10", "drive.rate_hz=10", "sensor.noise=0")
_TILE_PX = (256, 160)
# What counts as a step back: some of 200 tracks, a hundredth of the pixels or of the largest value.
_SLACK_OF_TRACKS, _SLACK = 0.03, 0.01


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    names = [effect.name for effect in EFFECTS]
    parser.add_argument("effects", nargs="*", metavar="EFFECT", help=", ".join(names))
    parser.add_argument("--sheet", type=Path, help="draw the last frame of each severity there")
    request = parser.parse_args()
    if unknown := set(request.effects) - set(names):
        parser.error(f"no effect {', '.join(sorted(unknown))}; there are: {', '.join(names)}")
    rows, reversals = [], 0
    for effect in EFFECTS:
        if not request.effects or effect.name in request.effects:
            ladder = list(frames_by_value(effect))
            reversals += report(effect, ladder)
            rows.append(
                [labelled(frames[-1], effect, v) for frames, v in zip(ladder, effect.values, strict=True)]
            )
    if request.sheet:
        cv2.imwrite(
            str(request.sheet), np.vstack([np.hstack(row) for row in rows]), [cv2.IMWRITE_JPEG_QUALITY, 85]
        )
    sys.exit(1 if reversals else 0)


def frames_by_value(effect: Effect) -> Iterator[list[Image]]:
    """Yield the frames of each severity."""
    scene = None
    for value in effect.values:
        scenario = load_scenario("first_drive", [*PLAIN, *effect.settings_at(value)])
        if scene is None or not effect.is_of_the_sensor:
            scene = build_scene(scenario.world, scenario.rig, 0)
        yield drive(scene, scenario.world, effect.from_s)


def drive(
    scene: Scene, world: WorldConfig, from_s: float, camera: str = CAMERA, count: int = FRAMES
) -> list[Image]:
    """Return a camera's frames."""
    stage = Stage(scene, world.drive)
    assert scene.atmosphere is not None
    air = OnBoardAtmosphere(scene.atmosphere, scene.model, stage.at)
    cameras = CameraArray({camera: scene.lenses[camera]}, world.sensor, 0, air)
    with ClassicRenderer(scene.model) as renderer:
        return [cameras.take(stage, renderer, k, from_s + k * PERIOD_S)[camera] for k in range(count)]


def measured(frames: Sequence[Image], effect: Effect) -> dict[str, float]:
    """Return the mean of every statistic."""
    cut = [frame[slice(*effect.rows), slice(*effect.columns)] for frame in frames]
    of_light = {
        "mean_level": float(np.mean(cut)),
        "white_share": float(np.mean(np.array(cut) > 250)),
    }
    return of_light | {name: float(values.mean()) for name, values in statistics_of(cut).items()}


def report(effect: Effect, ladder: Sequence[Sequence[Image]]) -> int:
    """Print one effect's table and return how many of its statistics reverse."""
    steps = [measured(frames, effect) for frames in ladder]
    print(f"\n{effect.name}: {effect.why}")
    print(f"{'':<20}" + "".join(f"{value:>9g}" for value in effect.values))
    count = 0
    for name in steps[0]:
        values = [step[name] for step in steps]
        verdict = judged(name, values, effect)
        count += verdict == "REVERSES"
        print(
            f"{name:<20}" + "".join(f"{value:>9.{_digits(name)}f}" for value in values) + f"  {verdict}",
            flush=True,
        )
    return count


def judged(name: str, values: Sequence[float], effect: Effect) -> str:
    """Return the mark of one row."""
    sign = (name in effect.rises) - (name in effect.falls)
    if not sign:
        return "-"
    slack = _SLACK if "share" in name else _SLACK * max(map(abs, values))
    slack = _SLACK_OF_TRACKS if "klt" in name else slack
    goes_on = all(sign * (after - before) > -slack for before, after in pairwise(values))
    arrives = sign * (values[-1] - values[0]) > slack
    return {1: "<", -1: ">"}[sign] if goes_on and arrives else "REVERSES"


def _digits(name: str) -> int:
    return 2 if name.endswith("share") or "klt" in name or "slope" in name else 1


def labelled(image: Image, effect: Effect, value: float) -> Image:
    """Return a small copy that says what it shows."""
    small = cv2.resize(image, _TILE_PX, interpolation=cv2.INTER_AREA)
    for level, width in ((0, 3), (255, 1)):
        cv2.putText(
            small,
            f"{effect.name} {value:g}",
            (5, 14),
            cv2.FONT_HERSHEY_SIMPLEX,
            0.42,
            level,
            width,
            cv2.LINE_AA,
        )
    return np.asarray(small, np.uint8)


if __name__ == "__main__":
    main()
