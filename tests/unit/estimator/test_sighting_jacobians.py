"""Every column is what small changes really do, for every lens and with clocks that are off."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from estimator.clocks import Clocks
from estimator.corrections import rig_at
from estimator.scene import Scene
from estimator.se3 import Array
from estimator.sighting_jacobians import sighting_jacobians
from estimator.unknowns import Unknowns
from tests.known_scene import known_scene, sightings
from tests.mounts import BROWN, FISHEYE, PINHOLE, arc, left_side_rig

RIG = left_side_rig(PINHOLE, BROWN, FISHEYE)
UNKNOWNS = Unknowns(RIG)
SCENE = replace(
    known_scene(RIG, arc(0.5, 5)), clocks=Clocks(tuple(10**8 * k for k in range(5)), (0.0, 0.02, -0.01))
)
SEEN = sightings(SCENE)
FOUND = sighting_jacobians(SCENE, SEEN)


def slope(moved: Callable[[float], Scene], step: float = 1e-5) -> Array:
    """Return (N, 2) how fast the pixels move."""
    points = SEEN.landmark, SEEN.camera, SEEN.keyframe
    ahead, behind = (
        scene.predict(points[1], points[2], scene.points_world[points[0]])
        for scene in (moved(step), moved(-step))
    )
    return np.asarray((ahead - behind) / (2 * step))


def agrees(columns: Array, expected: Array) -> None:
    np.testing.assert_allclose(columns, expected, atol=2e-3, rtol=2e-4)


def with_unknown(row: int, by: float) -> Scene:
    return replace(SCENE, rig=rig_at(RIG, by * np.eye(UNKNOWNS.size)[row]))


@pytest.mark.parametrize("axis", range(6))
def test_by_extrinsics(axis: int) -> None:
    moves = sum(slope(lambda by, c=c: with_unknown(6 * c + axis, by)) for c in range(2))  # type: ignore[misc]
    estimated = SEEN.camera > 0
    agrees(FOUND.by_extrinsics[estimated, :, axis], np.asarray(moves)[estimated])


@pytest.mark.parametrize("axis", range(3))
def test_by_lens(axis: int) -> None:
    rows = [UNKNOWNS.lens(camera).start + axis for camera in range(3)]
    moves = sum(slope(lambda by, row=row: with_unknown(row, by)) for row in rows)  # type: ignore[misc]
    agrees(FOUND.by_lens[:, :, axis], np.asarray(moves))


@pytest.mark.parametrize("axis", range(3))
def test_by_landmark(axis: int) -> None:
    shift = np.eye(3)[axis]
    moves = slope(lambda by: replace(SCENE, points_world=SCENE.points_world + by * shift))
    agrees(FOUND.by_point[:, :, axis], moves)


@pytest.mark.parametrize("axis", range(6))
def test_by_pose(axis: int) -> None:
    """All poses move alike in their own frames, so that the car's velocity hardly changes."""
    turn = np.eye(6)[axis]
    moves = slope(
        lambda by: replace(SCENE, world_from_egos=tuple(p.retract(by * turn) for p in SCENE.world_from_egos))
    )
    in_time = SEEN.camera == 0
    agrees(FOUND.by_pose[in_time, :, axis], moves[in_time])


def test_by_clock() -> None:
    assert SCENE.clocks is not None
    clocks = SCENE.clocks

    def moved(by: float) -> Scene:
        return replace(SCENE, clocks=replace(clocks, ahead_s=tuple(a + by for a in clocks.ahead_s)))

    agrees(FOUND.by_clock, slope(moved))


def test_the_residual_is_predicted_minus_measured() -> None:
    off = replace(SEEN, pixels=SEEN.pixels - [1.0, 2.0])
    np.testing.assert_allclose(
        sighting_jacobians(SCENE, off).residual_px, np.tile([1.0, 2.0], (len(SEEN), 1)), atol=1e-9
    )
