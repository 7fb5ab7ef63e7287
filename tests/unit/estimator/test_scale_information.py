"""What each source of a window says of scale."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from estimator.belief import Belief
from estimator.factors import GraphConfig
from estimator.graph import adjust
from estimator.loss import Loss
from estimator.rig import Rig, RigPrior
from estimator.scale import BELIEF, REAR_AXLE, ROAD, ScaleInformation
from tests.known_scene import known_scene, on_road, sightings
from tests.mounts import arc, left_side_rig

RIG = left_side_rig()


def information(
    curvature_per_m: float = 0.0, *, period_ns: int = 400_000_000, rig: Rig = RIG, road: bool = True
) -> ScaleInformation:
    scene = known_scene(rig, arc(1.0, 6, curvature_per_m))
    scene = replace(scene, stamps_ns=tuple(index * period_ns for index in range(6)))
    lying = on_road(scene) & road
    belief = Belief.nominal(rig)
    return adjust(
        scene, sightings(scene), lying, belief, Loss(10.0), GraphConfig(), want_covariance=True
    ).scale_information


def test_the_road_says_what_its_ride_heights_allow() -> None:
    one_height = (RIG["front"].ego_from_cam.translation[2] / GraphConfig().stance.height_sigma_m) ** 2
    assert 2 * one_height < information()[ROAD] < 6 * one_height
    assert information(road=False)[ROAD] < 1e-3 * one_height


def test_a_car_that_brakes_or_turns_hard_says_less_of_its_height() -> None:
    calm, hard = (information(1 / 10, period_ns=period)[ROAD] for period in (1_000_000_000, 100_000_000))
    assert 0.05 * calm < hard < 0.5 * calm


def test_the_rear_axle_speaks_in_turns_only_and_louder_in_slow_ones() -> None:
    assert information(0.0)[REAR_AXLE] < 1e-6
    assert information(1 / 10)[REAR_AXLE] > 100.0
    assert information(1 / 10, period_ns=100_000_000)[REAR_AXLE] < 0.5 * information(1 / 10)[REAR_AXLE]


@pytest.mark.parametrize("translation_mm", [20.0, 60.0])
def test_the_nominal_rig_says_what_its_distances_from_the_reference_do(translation_mm: float) -> None:
    rig = replace(RIG, prior=RigPrior(2.0, translation_mm))
    origin = rig["front"].ego_from_cam.translation
    away_m = [rig[name].ego_from_cam.translation - origin for name in rig.estimated_names]
    wanted = np.sum(np.square(away_m)) / (translation_mm / 1000) ** 2 * 3
    assert information(rig=rig)[BELIEF] == pytest.approx(wanted, rel=0.02)
