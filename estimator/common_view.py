"""Watch cameras that look the same way side by side: each should find the other's landmarks.

They fit each other's mounts, so nothing in how their own tracks move shows that their cables are swapped.
What they share does: a landmark is then sought on the wrong side.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

import numpy as np

from estimator.config import Config
from estimator.estimate import Match
from estimator.finding import Finding, FindingKind
from estimator.ranges import AngleRad, Count, LengthM, Share
from estimator.rig import Rig


class CommonViewConfig(Config):
    """Which pairs must share landmarks, and how many windows may pass in which they share hardly any."""

    distance_m: LengthM = 12.0
    min_overlap: Share = 0.5
    max_angle_rad: AngleRad = 0.35
    min_matches: Count = 8
    min_sightings: Count = 200


class CommonViewWatch:
    """Remembers which overlapping pairs shared hardly a landmark in the newest window that could tell."""

    def __init__(self, rig: Rig, config: CommonViewConfig) -> None:
        self._config = config
        self._pairs = [pair for pair in combinations(rig.cameras, 2) if _look_alike(rig, *pair, config)]
        self._poor: dict[tuple[str, str], int] = {}

    def see(self, matches: Sequence[Match], sightings: Mapping[str, int]) -> None:
        """Take note of what a window's cameras shared, and of how much each of them saw."""
        shared = Counter(frozenset((match.camera_a, match.camera_b)) for match in matches)
        for pair in self._pairs:
            if min(sightings[name] for name in pair) < self._config.min_sightings:
                continue
            self._poor.pop(pair, None)
            if shared[frozenset(pair)] < self._config.min_matches:
                self._poor[pair] = shared[frozenset(pair)]

    def findings(self) -> Iterator[Finding]:
        """Yield the pairs that share too little."""
        for pair, count in self._poor.items():
            about = (
                f"{pair[0]} and {pair[1]} look at the same things by the rig file, but recognise {count} of "
                "each other's landmarks: swapped with each other, or with others, or mounted elsewhere"
            )
            yield Finding(FindingKind.UNEXPLAINED_IMAGES, pair, about)


def _look_alike(rig: Rig, a: str, b: str, config: CommonViewConfig) -> bool:
    """Tell whether two cameras look the same way, and most of one's view lies in the other's."""
    cosine = rig[a].ego_from_cam.rotation[:, 2] @ rig[b].ego_from_cam.rotation[:, 2]
    if cosine < np.cos(config.max_angle_rad):
        return False
    share = max(_seen_by(rig, a, b, config.distance_m), _seen_by(rig, b, a, config.distance_m))
    return share > config.min_overlap


def _seen_by(rig: Rig, owner: str, other: str, distance_m: float) -> float:
    width, height = rig[owner].camera.size_px
    across, down = np.meshgrid(np.linspace(0, width - 1, 16), np.linspace(0, height - 1, 10))
    rays = rig[owner].camera.unproject(np.column_stack([across.ravel(), down.ravel()]))
    rays = rays[np.isfinite(rays).all(1)]
    other_from_owner = rig[other].ego_from_cam.inverse() @ rig[owner].ego_from_cam
    points = other_from_owner.apply(distance_m * rays)
    seen = rig[other].camera.contains(rig[other].camera.project(points)) & (points[:, 2] > 0)
    return float(seen.mean()) if len(seen) else 0.0
