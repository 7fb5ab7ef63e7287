"""Do places of a scenario differ, or would a matcher fold the street onto itself?

``python -m tests.benchmark.places [SCENARIO] [--seed N] [--set KEY=VALUE ...]`` counts geometrically verified
SIFT matches between images that have nothing in common: of one camera at places over 30 m apart, and of
cameras that look in opposite directions. Matches whose two points are one place of the world, by true depth,
are no mistakes and counted apart: what closes a street is seen from all of it, and a lorry ahead comes
along, and so does the car that carries the cameras. Prints the worst pairs. Exit code 1 if one has more
than ``--most`` wrong matches.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from itertools import combinations
from typing import NamedTuple

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
_SAME_PLACE_M = 1.0  # true depth is that of the matched pixel, which may lie beside the edge that was matched
_SKY_M = 1e3
ALONG = ("traffic_", "chassis")  # begin the names of what drives and walks, and of the car itself
_OPPOSITE_COS = np.cos(np.radians(150))


@dataclass(frozen=True, eq=False)
class Sight:
    """What one camera saw at one place."""

    camera: str
    position_m: np.ndarray
    axis: np.ndarray
    points_px: np.ndarray
    descriptors: np.ndarray
    points_world_m: np.ndarray
    things: np.ndarray  # name of what each feature is on


class Verdict(NamedTuple):
    """Verified matches of two sights: how many are wrong, how many true, and what is taken for what."""

    wrong: int
    true: int
    mistaken: str


def verified_matches(first: Sight, second: Sight) -> Verdict:
    """Return the mutual SIFT matches that agree with one fundamental matrix."""
    if min(len(first.points_px), len(second.points_px)) < 8:
        return Verdict(0, 0, "")
    there, back = _nearest(first, second), _nearest(second, first)
    pairs = [(i, j) for i, j in there.items() if back.get(j) == i]
    if len(pairs) < 8:
        return Verdict(0, 0, "")
    ours, theirs = (
        points[list(indices)]
        for points, indices in zip((first.points_px, second.points_px), zip(*pairs, strict=True), strict=True)
    )
    cv2.setRNGSeed(0)
    try:
        _, inliers = cv2.findFundamentalMat(ours, theirs, cv2.USAC_MAGSAC, _EPIPOLAR_PX, 0.999, 5000)
    except cv2.error:  # OpenCV 5 asserts that some sample gives a model
        return Verdict(0, 0, "")
    if inliers is None:
        return Verdict(0, 0, "")
    ends_m = (
        points[list(indices)]
        for points, indices in zip(
            (first.points_world_m, second.points_world_m), zip(*pairs, strict=True), strict=True
        )
    )
    gap_m = np.linalg.norm(np.subtract(*ends_m), axis=1)  # of the sky nan, which is near to nothing
    here, there_too = (
        names[list(indices)]
        for names, indices in zip((first.things, second.things), zip(*pairs, strict=True), strict=True)
    )
    goes_along = np.any([np.char.startswith(here, name) for name in ALONG], axis=0) & (here == there_too)
    agree, same = inliers.ravel().astype(bool), (gap_m < _SAME_PLACE_M) | goes_along
    wrong = Counter(zip(here[agree & ~same], there_too[agree & ~same], strict=True)).most_common(1)
    return Verdict(
        int((agree & ~same).sum()), int((agree & same).sum()), " for ".join(wrong[0][0]) if wrong else ""
    )


def _nearest(ours: Sight, theirs: Sight) -> dict[int, int]:
    """Return, by our feature, the one of theirs that is clearly nearest."""
    candidates = cv2.BFMatcher(cv2.NORM_L2).knnMatch(ours.descriptors, theirs.descriptors, 2)
    clear = (best for best, next_best in candidates if best.distance < _RATIO * next_best.distance)
    return {match.queryIdx: match.trainIdx for match in clear}


def sights(scenario_name: str, seed: int, settings: Sequence[str]) -> Iterator[Sight]:
    """Drive with a bundle every ten metres and yield what every camera sees."""
    speed_mps = load_scenario(scenario_name, settings).world.drive.speed_mps
    rate_hz = max(1.0, speed_mps / _SPACING_M)
    scenario = load_scenario(
        scenario_name, [*settings, f"drive.rate_hz={rate_hz}", "truth=[depth,segmentation]"]
    )
    sift = cv2.SIFT.create(_FEATURES)
    last_m = None
    with closing(simulate(scenario.world, scenario.rig, seed)) as snapshots:
        for snapshot in snapshots:
            world_from_ego = snapshot.truth.world_from_ego
            if last_m is not None and np.linalg.norm(world_from_ego.translation - last_m) < 0.9 * _SPACING_M:
                continue
            last_m = world_from_ego.translation
            for camera, image in snapshot.bundle.images.items():
                world_from_cam = world_from_ego @ snapshot.truth.ego_from_cams[camera]
                points_px, descriptors = _features(sift, image)
                rays_cam = scenario.rig[camera].camera.unproject(points_px)
                rays_cam /= np.linalg.norm(rays_cam, axis=1, keepdims=True)
                columns, rows = np.rint(points_px).astype(int).reshape(-1, 2).T
                assert snapshot.channels is not None, "depth was asked for"
                range_m = snapshot.channels.range_m[camera][rows, columns]
                points_m = world_from_cam.apply(rays_cam * np.minimum(range_m, _SKY_M)[:, None])
                points_m[range_m >= _SKY_M] = np.nan
                axis = world_from_cam.rotation[:, 2]
                instance = snapshot.channels.instances[camera][rows, columns]
                names = snapshot.channels.labels.instance_names
                things = np.array(names)[instance]
                yield Sight(camera, last_m, axis, points_px, descriptors, points_m, things)


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
    counts: dict[str, list[tuple[int, int, str, str]]] = {}
    seen = list(sights(arguments.scenario, arguments.seed, arguments.settings))
    for why, first, second in unrelated(seen):
        where = f"{_name(first)} and {_name(second)}"
        counts.setdefault(why, []).append((*verified_matches(first, second), where))
    worst = 0
    for why, each in counts.items():
        wrong, true = np.array([pair[:2] for pair in each]).T
        worst = max(worst, int(wrong.max()))
        print(
            f"{why}: {len(each)} pairs, median {np.median(wrong):.0f}, worst {wrong.max()} matches; "
            f"besides, up to {true.max()} of things that both see"
        )
        for count, besides, mistaken, where in sorted(each, reverse=True)[:3]:
            print(f"  {count:4d} + {besides:3d}  {where}: mostly {mistaken}")
    return 0 if worst <= arguments.most else 1


def _name(sight: Sight) -> str:
    x_m, y_m, _ = sight.position_m
    return f"{sight.camera} at ({x_m:.0f}, {y_m:.0f})"


if __name__ == "__main__":
    sys.exit(main())
