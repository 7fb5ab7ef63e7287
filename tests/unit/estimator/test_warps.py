"""How the view of a plane changes from one camera to another."""

from __future__ import annotations

import numpy as np
import pytest

from estimator.scene import Scene
from estimator.warps import plane_warp
from tests.mounts import BROWN, FISHEYE, PINHOLE, arc, left_side_rig

ROAD = np.array([[6.0, 1.0, 0.0], [7.5, -0.5, 0.0], [9.0, 0.8, 0.0]])
UP = np.tile([0.0, 0.0, 1.0], (3, 1))


def at(*values: int) -> np.ndarray:
    return np.array(values, dtype=np.int64)


def scene(*lenses: object) -> Scene:
    return Scene(left_side_rig(*lenses), arc(1.0, 3), ROAD)


def test_the_warp_to_the_same_view_is_the_identity() -> None:
    view = (at(0, 0, 0), at(1, 1, 1))
    known = scene()
    warps = plane_warp(known, view, view, ROAD, UP, known.predict(*view, ROAD))
    np.testing.assert_allclose(warps.linear, np.tile(np.eye(2), (3, 1, 1)), atol=1e-9)
    np.testing.assert_allclose(warps.perspective, 0, atol=1e-9)


@pytest.mark.parametrize("lens", [PINHOLE, BROWN, FISHEYE])
def test_the_warp_carries_a_whole_patch_on_the_plane(lens: object) -> None:
    known = scene(lens, lens)
    anchor, target = (at(0, 0, 0), at(2, 2, 2)), (at(0, 0, 0), at(0, 0, 0))
    warps = plane_warp(known, anchor, target, ROAD, UP, known.predict(*target, ROAD))
    misses, linear_misses = [], []
    for step in np.array([[0.2, 0.0, 0.0], [-0.2, 0.06, 0.0], [0.0, -0.1, 0.0]]):
        in_anchor, in_target = (
            known.predict(*view, ROAD + step) - known.predict(*view, ROAD) for view in (anchor, target)
        )
        linear = np.einsum("nij,nj->ni", warps.linear, in_target)
        misses.append(np.abs(warps.apply(in_target[:, None])[:, 0] - in_anchor).max())
        linear_misses.append(np.abs(linear - in_anchor).max())
    assert max(misses) < 0.04
    assert max(linear_misses) > 2 * max(misses), "this is what the perspective part is for"


def test_a_plane_behind_the_camera_has_no_warp() -> None:
    known = scene()
    view = (at(0), at(0))
    behind = np.array([[-5.0, 0.0, 0.0]])
    wall = np.array([[1.0, 0.0, 0.0]])
    assert not plane_warp(known, view, view, behind, wall, np.array([[160.0, 100.0]])).finite.any()


def test_a_plane_behind_the_target_has_no_warp_though_the_anchor_sees_it() -> None:
    known = scene()
    point, facing_ahead = np.array([[-4.0, 5.0, 1.2]]), np.array([[1.0, 0.0, 0.0]])
    front = known.camera_pose(0, 0)
    mirrored = 2 * front.translation - point
    target_px = known.predict(at(0), at(0), mirrored)
    assert np.isfinite(target_px).all() and np.isfinite(known.predict(at(2), at(0), point)).all()
    assert not plane_warp(known, (at(2), at(0)), (at(0), at(0)), point, facing_ahead, target_px).finite.any()
