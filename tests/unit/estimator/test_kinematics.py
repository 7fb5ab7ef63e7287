"""The rear axle as a source of metres: only in turns, forwards and backwards, and not where it slips."""

from __future__ import annotations

import gtsam
import numpy as np
import pytest

from estimator.kinematics import RearAxleConfig, add_rear_axle, sideways_m
from estimator.se3 import SE3
from tests.mounts import arc

NO_SLIP = np.zeros(2)
STILL = RearAxleConfig(slip_rad_per_mps2=0.0)
FORWARD, BACKWARD = arc(1.0, 5, 1 / 15), arc(-1.0, 5, 1 / 15)


def sideways(before: SE3, after: SE3, slip: np.ndarray = NO_SLIP, acceleration_mps2: float = 0.0) -> float:
    chord = after.translation - before.translation
    return sideways_m((before.rotation, after.rotation), chord, slip, acceleration_mps2)[0]


def cost(poses: tuple[SE3, ...], period_ns: int = 400_000_000, config: RearAxleConfig = STILL) -> float:
    """Return the error of a path with its slip at the expected value."""
    graph, values = gtsam.NonlinearFactorGraph(), gtsam.Values()
    for index, pose in enumerate(poses):
        values.insert(index, gtsam.Pose3(gtsam.Rot3(pose.rotation), pose.translation))
    stamps_ns = [index * period_ns for index in range(len(poses))]
    add_rear_axle(graph, values, poses, stamps_ns, range(len(poses)), 99, config)
    return float(graph.error(values))


def of_a_point_ahead(poses: tuple[SE3, ...], metres: float) -> tuple[SE3, ...]:
    """Return the path of a point ahead of the axle: what a wrong scale makes of a turn."""
    return tuple(pose @ SE3(np.eye(3), np.array([metres, 0.0, 0.0])) for pose in poses)


@pytest.mark.parametrize("poses", [FORWARD, BACKWARD, arc(1.0, 5, 0.0)], ids=["ahead", "back", "straight"])
def test_an_axle_that_rolls_where_it_points_costs_nothing(poses: tuple[SE3, ...]) -> None:
    assert cost(poses) < 1e-20


@pytest.mark.parametrize("poses", [FORWARD, BACKWARD], ids=["ahead", "back"])
def test_in_a_turn_a_point_ahead_of_the_axle_moves_sideways(poses: tuple[SE3, ...]) -> None:
    assert cost(of_a_point_ahead(poses, 0.1)) > 1.0
    assert cost(of_a_point_ahead(arc(1.0, 5, 0.0), 0.1)) < 1e-20


@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_the_axle_slips_to_the_outside_of_the_turn_whichever_way_it_rolls(direction: float) -> None:
    drift = np.array([0.0, 0.0, direction * 0.05, direction, -0.006, 0.0])  # turns left, slips right
    slip = np.array([0.0, -0.006])
    assert abs(sideways(SE3(), SE3.exp(drift), slip, 1.0)) < 1e-4
    assert sideways(SE3(), SE3.exp(drift)) < -0.005


def test_a_hard_turn_is_believed_less_than_a_slow_one() -> None:
    off = of_a_point_ahead(FORWARD, 0.1)
    assert cost(off, 200_000_000) < 0.7 * cost(off, 2_000_000_000)


def test_the_derivatives_are_those_of_the_error() -> None:
    rng = np.random.default_rng(0)
    poses = [SE3.exp(0.3 * rng.standard_normal(6)) for _ in range(2)]
    slip = np.array([0.01, 0.02])

    def moved(change: np.ndarray) -> float:
        before, after = poses[0].retract(change[:6]), poses[1].retract(change[6:12])
        return sideways(before, after, slip + change[12:], 0.7)

    numeric = [(moved(1e-6 * axis) - moved(-1e-6 * axis)) / 2e-6 for axis in np.eye(14)]
    rotations, chord = (poses[0].rotation, poses[1].rotation), poses[1].translation - poses[0].translation
    stated = np.hstack(sideways_m(rotations, chord, slip, 0.7)[1])[0]
    np.testing.assert_allclose(stated, numeric, atol=1e-8)
