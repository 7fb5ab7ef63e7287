"""People walk and ride as people do: feet stay put, limbs stay joined, poses reach the world unharmed."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.shapes.bicycle import BOTTOM_BRACKET_M, CRANK_M, WHEELBASE_M
from sim.shapes.person import ANKLE_M, SHIN_M, THIGH_M
from sim.traffic import pedalling, walking
from sim.traffic.pose import PITCH, Stance, X, Y, Z, in_world

ONE = np.ones(1)


def walk(travelled_m: float, speed_mps: float = 1.3) -> Array:
    poses: Array = walking.walking(np.array([travelled_m]), speed_mps * ONE, ONE, 0 * ONE)[0]
    return poses


def part(poses: Array, name: str) -> Array:
    pose: Array = poses[walking.PARTS.index(name)]
    return pose


def lowest_m(foot: Array) -> float:
    x, z = np.array([[-0.08, -ANKLE_M], [0.14, -ANKLE_M], [0.185, -ANKLE_M + 0.014]]).T
    return float((foot[Z] - x * np.sin(foot[PITCH]) + z * np.cos(foot[PITCH])).min())


def test_one_foot_is_always_on_the_ground_and_none_below() -> None:
    for travelled in np.linspace(0.0, 1.38, 40):
        feet = [lowest_m(part(walk(float(travelled)), f"{side}_foot")) for side in ("left", "right")]
        assert abs(min(feet)) < 1e-9


def test_a_foot_on_the_ground_hardly_slides() -> None:
    slides = []
    for travelled in np.linspace(0.05, 0.45, 20):  # the left leg carries
        before, after = (part(walk(float(travelled + d)), "left_foot")[X] + d for d in (0.0, 0.02))
        slides.append(after - before)
    assert np.abs(slides).mean() < 0.5 * 0.02


def test_knees_stay_joined() -> None:
    poses = walk(0.37)
    thigh, shin, foot = (part(poses, f"left_{name}") for name in ("thigh", "shin", "foot"))
    np.testing.assert_allclose(np.hypot(*(shin - thigh)[[X, Z]]), THIGH_M)
    np.testing.assert_allclose(np.hypot(*(foot - shin)[[X, Z]]), SHIN_M)


def test_who_waits_stands_still_and_upright() -> None:
    np.testing.assert_allclose(walk(0.2, 0.0), walk(0.9, 0.0))
    assert np.abs(walk(0.2, 0.0)[:, PITCH]).max() < 0.2


def test_feet_go_round_with_the_pedals() -> None:
    ways = np.linspace(0, 4.6, 30)
    poses = pedalling.pedalling(ways, 0 * ways)
    foot = poses[:, pedalling.PARTS.index("left_foot")]
    tip = foot[:, PITCH]
    ball_x = foot[:, X] + 0.1 * np.cos(tip) - (ANKLE_M + 0.012) * np.sin(tip)
    ball_z = foot[:, Z] - 0.1 * np.sin(tip) - (ANKLE_M + 0.012) * np.cos(tip)
    reach = np.hypot(ball_x + WHEELBASE_M / 2 - BOTTOM_BRACKET_M[0], ball_z - BOTTOM_BRACKET_M[2])
    np.testing.assert_allclose(reach, CRANK_M, atol=1e-9)


def test_rider_legs_stay_joined() -> None:
    ways = np.linspace(0, 4.6, 30)
    poses = pedalling.pedalling(ways, 0 * ways)
    thigh, shin, foot = (poses[:, pedalling.PARTS.index(f"right_{n}")] for n in ("thigh", "shin", "foot"))
    np.testing.assert_allclose(np.hypot(*(shin - thigh)[:, [X, Z]].T), THIGH_M, atol=1e-6)
    np.testing.assert_allclose(np.hypot(*(foot - shin)[:, [X, Z]].T), SHIN_M, atol=0.02)


def test_parts_turn_with_their_actor() -> None:
    stance = Stance(np.array([[5.0, 1.0, 0.2]]), np.array([np.pi / 2]), np.array([0.0]))
    parts = np.zeros((1, 1, 5))
    parts[0, 0, [X, Y, Z, PITCH]] = 1.0, 0.5, 0.3, 0.4
    position, quaternion = in_world(stance, parts)
    np.testing.assert_allclose(position[0, 0], [4.5, 2.0, 0.5], atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(quaternion[0, 0]), 1.0)
    # Pitched by 0.4 about its own y, then headed to +y: what pointed ahead now points to +y and down.
    w, v = quaternion[0, 0, 0], quaternion[0, 0, 1:]
    ahead = np.array([1.0, 0, 0])
    turned = ahead + 2 * w * np.cross(v, ahead) + 2 * np.cross(v, np.cross(v, ahead))
    np.testing.assert_allclose(turned, [0.0, np.cos(0.4), -np.sin(0.4)], atol=1e-12)
