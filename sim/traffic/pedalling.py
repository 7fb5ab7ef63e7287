"""How a bicycle and its rider's legs move, as a function of the way ridden."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.shapes.bicycle import BOTTOM_BRACKET_M, CRANK_M, WHEEL_M, WHEELBASE_M
from sim.shapes.person import ANKLE_M, SHIN_M, THIGH_M
from sim.shapes.rider import HIP_M
from sim.traffic.pose import PITCH, X, Y, Z

_LEGS = tuple(f"{side}_{limb}" for side in ("left", "right") for limb in ("thigh", "shin", "foot"))
PARTS = ("frame", "rear_wheel", "front_wheel", "cranks", *_LEGS)
_DEVELOPMENT_M = 4.6  # of road a turn of the cranks
_MIDDLE_M = WHEELBASE_M / 2  # of the actor, ahead of the rear axle
_PEDAL_FROM_ANKLE_M = (0.1, -ANKLE_M - 0.012)  # x ahead, z


def pedalling(travelled_m: Array, start_turns: Array) -> Array:
    """Return (N, 10, 5) part poses of N cyclists in the order of ``PARTS``; both arguments are (N,)."""
    poses = np.zeros((len(travelled_m), len(PARTS), 5))
    poses[:, 1, Z], poses[:, 2, Z], poses[:, 2, X] = WHEEL_M, WHEEL_M, WHEELBASE_M
    poses[:, 1:3, PITCH] = (travelled_m / WHEEL_M)[:, None]
    turned_rad = 2 * np.pi * (travelled_m / _DEVELOPMENT_M + start_turns)
    poses[:, 3, X], poses[:, 3, Z], poses[:, 3, PITCH] = BOTTOM_BRACKET_M[0], BOTTOM_BRACKET_M[2], turned_rad
    for k, side in enumerate((1.0, -1.0)):
        _place_leg(poses, 4 + 3 * k, side, turned_rad + k * np.pi)
    poses[..., X] -= _MIDDLE_M
    return poses


def _place_leg(poses: Array, first: int, side: float, crank_rad: Array) -> None:
    """Two links from the hip to an ankle that the pedal carries round; its foot tips down as it rises."""
    tip = 0.22 - 0.16 * np.sin(crank_rad + 0.4)
    dx, dz = _PEDAL_FROM_ANKLE_M
    ankle_x = BOTTOM_BRACKET_M[0] + CRANK_M * np.cos(crank_rad) - dx * np.cos(tip) - dz * np.sin(tip)
    ankle_z = BOTTOM_BRACKET_M[2] - CRANK_M * np.sin(crank_rad) + dx * np.sin(tip) - dz * np.cos(tip)
    way_x, way_z = ankle_x - HIP_M[0], ankle_z - HIP_M[2]
    reach = np.minimum(np.hypot(way_x, way_z), 0.998 * (THIGH_M + SHIN_M))
    at_hip = np.arccos(np.clip((THIGH_M**2 + reach**2 - SHIN_M**2) / (2 * THIGH_M * reach), -1, 1))
    thigh = np.arctan2(-way_x, -way_z) - at_hip
    knee_x, knee_z = HIP_M[0] - THIGH_M * np.sin(thigh), HIP_M[2] - THIGH_M * np.cos(thigh)
    shin = np.arctan2(knee_x - ankle_x, knee_z - ankle_z)
    rows = ((HIP_M[0], HIP_M[2], thigh), (knee_x, knee_z, shin), (ankle_x, ankle_z, tip))
    for k, (x, z, pitch) in enumerate(rows):
        poses[:, first + k, X], poses[:, first + k, Z], poses[:, first + k, PITCH] = x, z, pitch
        poses[:, first + k, Y] = side * (HIP_M[1] + 0.02 * k)
