"""Do places of a scenario differ, or would a matcher fold the street onto itself?

``python -m tests.benchmark.places [SCENARIO] [--seed N] [--set KEY=VALUE ...]`` counts geometrically verified
SIFT matches between images that have nothing in common: of one camera at places over 30 m apart, and of
cameras that look in opposite directions. Prints the worst pairs. Exit code 1 if one has more than ``--most``.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from itertools import combinations

import cv2
import numpy as np

from estimator.bundle import Image
from scenarios.load import load_scenario
from sim.simulate import simulate

_APART_M = 30.0
_SPACING_M = 10.0
_FEATURES = 1000
_RATIO = 0.8  # Lowe 2004, sec. 7.1
_EPIPOLAR_PX = 1.5
_OPPOSITE_COS = np.cos(np.radians(150))


@dataclass(frozen=True, eq=False)
class Sight:
    """What one camera saw at one place."""

    camera: str
    position_m: np.ndarray
    axis: np.ndarray
    points_px: np.ndarray
    descriptors: np.ndarray


def verified_matches(first: Sight, second: Sight) -> int:
    """Return how many mutual SIFT matches agree with one fundamental matrix."""
    if min(len(first.points_px), len(second.points_px)) < 8:
        return 0
    there, back = _nearest(first, second), _nearest(second, first)
    pairs = [(i, j) for i, j in there.items() if back.get(j) == i]
    if len(pairs) < 8:
        return 0
    ours, theirs = (
        points[list(indices)]
        for points, indices in zip((first.points_px, second.points_px), zip(*pairs, strict=True), strict=True)
    )
    cv2.setRNGSeed(0)
    _, inliers = cv2.findFundamentalMat(ours, theirs, cv2.USAC_MAGSAC, _EPIPOLAR_PX, 0.999, 5000)
    return 0 if inliers is None else int(inliers.sum())


def _nearest(ours: Sight, theirs: Sight) -> dict[int, int]:
    """Return, by our feature, the one of theirs that is clearly nearest."""
    candidates = cv2.BFMatcher(cv2.NORM_L2).knnMatch(ours.descriptors, theirs.descriptors, 2)
    clear = (best for best, next_best in candidates if best.distance < _RATIO * next_best.distance)
    return {match.queryIdx: match.trainIdx for match in clear}


def sights(scenario_name: str, seed: int, settings: Sequence[str]) -> Iterator[Sight]:
    """Drive with a bundle every ten metres and yield what every camera sees."""
    speed_mps = load_scenario(scenario_name, settings).world.drive.speed_mps
    rate_hz = max(1.0, speed_mps / _SPACING_M)
    scenario = load_scenario(scenario_name, [*settings, f"drive.rate_hz={rate_hz}"])
    sift = cv2.SIFT.create(_FEATURES)
    last_m = None
    with closing(simulate(scenario.world, scenario.rig, seed)) as snapshots:
        for snapshot in snapshots:
            world_from_ego = snapshot.truth.world_from_ego
            if last_m is not None and np.linalg.norm(world_from_ego.translation - last_m) < 0.9 * _SPACING_M:
                continue
            last_m = world_from_ego.translation
            for camera, image in snapshot.bundle.images.items():
                axis = world_from_ego.rotation @ snapshot.truth.ego_from_cams[camera].rotation[:, 2]
                yield Sight(camera, last_m, axis, *_features(sift, image))


def _features(sift: cv2.SIFT, image: Image) -> tuple[np.ndarray, np.ndarray]:
    points, descriptors = sift.detectAndCompute(image, None)
    pixels = np.array([point.pt for point in points]).reshape(-1, 2)
    return pixels, np.zeros((0, 128), np.float32) if descriptors is None else descriptors


def unrelated(all_sights: Sequence[Sight]) -> Iterator[tuple[str, Sight, Sight]]:
    """Yield pairs that show nothing in common, and why."""
    for first, second in combinations(all_sights, 2):
        apart_m = np.linalg.norm(first.position_m - second.position_m)
        if first.camera == second.camera and apart_m > _APART_M:
            yield "places apart", first, second
        elif first.camera != second.camera and first.axis @ second.axis < _OPPOSITE_COS:
            yield "opposite-facing", first, second


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenario", nargs="?", default="first_drive")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--set", dest="settings", action="append", default=[])
    parser.add_argument("--most", type=int, default=20)
    arguments = parser.parse_args()
    counts: dict[str, list[tuple[int, str]]] = {}
    seen = list(sights(arguments.scenario, arguments.seed, arguments.settings))
    for why, first, second in unrelated(seen):
        where = f"{_name(first)} and {_name(second)}"
        counts.setdefault(why, []).append((verified_matches(first, second), where))
    worst = 0
    for why, each in counts.items():
        matches = np.array([count for count, _ in each])
        worst = max(worst, int(matches.max()))
        print(f"{why}: {len(each)} pairs, median {np.median(matches):.0f}, worst {matches.max()} matches")
        for count, where in sorted(each, reverse=True)[:3]:
            print(f"  {count:4d}  {where}")
    return 0 if worst <= arguments.most else 1


def _name(sight: Sight) -> str:
    x_m, y_m, _ = sight.position_m
    return f"{sight.camera} at ({x_m:.0f}, {y_m:.0f})"


if __name__ == "__main__":
    sys.exit(main())
