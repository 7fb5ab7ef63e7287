"""The road gives metres whatever its shape."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from estimator.belief import Belief
from estimator.corridor import road_landmarks
from estimator.factors import GraphConfig
from estimator.graph import adjust
from estimator.loss import Loss
from estimator.rig import RigPrior
from estimator.scene import Scene
from tests.bent_road import Height, bent, crest
from tests.known_scene import known_scene, sightings
from tests.mounts import arc, left_side_rig

CONFIG = GraphConfig(iterations=60, relative_tolerance=1e-12)
FLAT = known_scene(left_side_rig(), arc(1.0, 8, 0.0), 20)
VAGUE = replace(FLAT.rig, prior=RigPrior(60.0, 10_000.0))


def ramp(x: np.ndarray) -> np.ndarray:
    return np.asarray(0.1 * x)


def hump(x: np.ndarray) -> np.ndarray:
    return np.asarray(0.035 * (1 + np.cos(np.pi * np.clip((x - 4.0) / 1.8, -1, 1))))


def path_m(scene: Scene) -> float:
    return float(np.linalg.norm(scene.world_from_egos[-1].translation - scene.world_from_egos[0].translation))


def scale_found(height: Height) -> float:
    """Return how much longer the path is after adjustment than in truth."""
    truth = bent(FLAT, height)
    seen = sightings(truth)
    road = road_landmarks(truth, seen, 0.08)
    assert road.sum() > 25
    found = adjust(truth, seen, road, Belief.nominal(VAGUE), Loss(10.0), CONFIG).scene
    return path_m(found) / path_m(truth) - 1


@pytest.mark.parametrize("bend_per_m", [0.0, 0.006, -0.006], ids=["flat", "crest", "sag"])
def test_a_crest_or_a_sag_is_not_taken_for_another_scale(bend_per_m: float) -> None:
    assert abs(scale_found(crest(bend_per_m))) < 0.002


def test_a_ramp_is_not_taken_for_another_scale() -> None:
    assert abs(scale_found(ramp)) < 1e-3


def test_a_hump_that_only_part_of_the_window_crosses_moves_the_scale_little() -> None:
    assert abs(scale_found(hump)) < 0.005
