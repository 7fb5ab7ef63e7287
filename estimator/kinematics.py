"""The rear axle rolls where it points: what turns and the car's build say of metres.

In the ego frame, whose origin lies under the rear axle, the car does not move sideways. In a turn the
cameras, which sit elsewhere, do, by so many metres a radian: that fixes scale. Tyres slip and mounts are not
exact, and both err the same way for metres on end; so each window has two unknowns of its own for them, and
straight driving teaches nothing. Holds in reverse.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

import gtsam
import numpy as np

from estimator.config import Config
from estimator.ranges import RadPerMps2, SigmaRad
from estimator.se3 import SE3, Array, skew


class RearAxleConfig(Config):
    """How a rear axle rolls.

    ``slip_rad_per_mps2`` is the slip angle that a metre per second squared of sideways acceleration costs:
    with the cornering stiffness of car tyres, 10 to 25 times their load a radian, 4 to 10 mrad.
    """

    heading_sigma_rad: SigmaRad = 0.005  # of the true axle against the ego frame
    slip_rad_per_mps2: RadPerMps2 = 0.006
    slip_sigma_rad_per_mps2: SigmaRad = 0.003
    floor: SigmaRad = 0.003  # metres sideways a metre, from one keyframe to the next
    per_mps2: RadPerMps2 = 0.002  # what the slip is off its own mean, more in harder turns


def add_rear_axle(
    graph: gtsam.NonlinearFactorGraph,
    values: gtsam.Values,
    world_from_egos: Sequence[SE3],
    stamps_ns: Sequence[int],
    pose_keys: Sequence[int],
    slip_key: int,
    config: RearAxleConfig,
) -> None:
    """Add a factor between consecutive poses, and the window's own heading error and slip.

    Args:
        graph: Grows by the factors.
        values: Grows by the window's (heading error in rad, slip in rad s^2/m), under ``slip_key``.
        world_from_egos: The poses at present, from which the sideways acceleration is taken.
        stamps_ns: When the car was there.
        pose_keys: The poses' keys.
        slip_key: Key of the new variable.
        config: Sigmas.
    """
    mean = np.array([0.0, -config.slip_rad_per_mps2])
    sigmas = np.array([config.heading_sigma_rad, config.slip_sigma_rad_per_mps2])
    values.insert(slip_key, mean)
    graph.add(gtsam.PriorFactorVector(slip_key, mean, gtsam.noiseModel.Diagonal.Sigmas(sigmas)))
    steps = zip(pairwise(pose_keys), pairwise(world_from_egos), pairwise(stamps_ns), strict=True)
    for keys, (before, after), (from_ns, to_ns) in steps:
        step = before.inverse() @ after
        length_m, duration_s = float(np.linalg.norm(step.translation)), (to_ns - from_ns) * 1e-9
        if duration_s <= 0:
            continue
        acceleration_mps2 = length_m * step.log()[2] / duration_s**2 * np.sign(step.translation[0])
        sigma_m = max(length_m, 0.1) * np.hypot(config.floor, config.per_mps2 * acceleration_mps2)
        noise = gtsam.noiseModel.Robust.Create(  # a car that skids is not believed
            gtsam.noiseModel.mEstimator.Cauchy.Create(2.0), gtsam.noiseModel.Isotropic.Sigma(1, sigma_m)
        )
        graph.add(gtsam.CustomFactor(noise, [*keys, slip_key], _sideways(acceleration_mps2)))


def _sideways(
    acceleration_mps2: float,
) -> Callable[[gtsam.CustomFactor, gtsam.Values, list[Array] | None], Array]:
    """Return the error of a step: metres sideways, seen in the mean of both headings, less the slip.

    The sideways acceleration is positive to the left, and the axle slips away from it, to the outside.
    """

    def error(factor: gtsam.CustomFactor, values: gtsam.Values, jacobians: list[Array] | None) -> Array:
        before, after, slip = factor.keys()
        pose, other = values.atPose3(before), values.atPose3(after)
        value, derivatives = sideways_m(
            (pose.rotation().matrix(), other.rotation().matrix()),
            other.translation() - pose.translation(),
            values.atVector(slip),
            acceleration_mps2,
        )
        if jacobians is not None:
            for index, derivative in enumerate(derivatives):
                jacobians[index] = derivative
        return np.array([value])

    return error


def sideways_m(
    rotations: tuple[Array, Array], chord_world: Array, slip: Array, acceleration_mps2: float
) -> tuple[float, tuple[Array, Array, Array]]:
    """Return how far a step went sideways beyond its slip, with its derivatives.

    On a circle the chord makes the same angle with the headings at both its ends, to opposite sides, so the
    mean of both sideways parts is exactly zero.

    Args:
        rotations: ``world_from_ego`` (3, 3) before and after.
        chord_world: (3,) from one rear axle to the other.
        slip: (2,) heading error of the ego frame, and slip by sideways acceleration.
        acceleration_mps2: Sideways, to the left.

    Returns:
        Metres to the left, and the (1, 6), (1, 6) and (1, 2) derivatives by the poses' right perturbations
        and by ``slip``.
    """
    local = [rotation.T @ chord_world for rotation in rotations]
    ahead_m = 0.5 * (local[0][0] + local[1][0])
    direction = float(np.sign(ahead_m))
    row = 0.5 * np.array([-slip[0] - slip[1] * acceleration_mps2 * direction, 1.0, 0.0])
    rows = [row @ rotation.T for rotation in rotations]  # in the world
    both = rows[0] + rows[1]
    by_poses = [
        np.hstack([row @ skew(chord), sign * both @ rotation])[None]
        for chord, rotation, sign in zip(local, rotations, (-1.0, 1.0), strict=True)
    ]
    by_slip = np.array([[-ahead_m, -acceleration_mps2 * abs(ahead_m)]])
    return float(row @ (local[0] + local[1])), (by_poses[0], by_poses[1], by_slip)
