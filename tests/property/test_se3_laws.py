"""The laws of a group, its exponential map and its adjoint."""

from __future__ import annotations

import gtsam
import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from estimator.se3 import SE3, Array


@st.composite
def tangents(draw: st.DrawFn, most_rad: float = 3.1) -> Array:
    """Draw a rotation of up to ``most_rad`` about any axis and a translation of up to 100 m an axis."""
    axis = np.array([draw(st.floats(-1, 1)) for _ in range(3)])
    norm = float(np.linalg.norm(axis))
    axis = axis / norm if norm > 1e-3 else np.array([0.0, 0.0, 1.0])
    translation_m = [draw(st.floats(-100, 100)) for _ in range(3)]
    return np.concatenate([axis * draw(st.floats(0, most_rad)), translation_m])


poses = tangents().map(SE3.exp)


def assert_same(a: SE3, b: SE3, atol: float = 1e-9) -> None:
    np.testing.assert_allclose(a.matrix, b.matrix, atol=atol)


@given(poses, poses, poses)
def test_composition_is_associative(a: SE3, b: SE3, c: SE3) -> None:
    assert_same((a @ b) @ c, a @ (b @ c))


@given(poses)
def test_the_inverse_undoes(pose: SE3) -> None:
    assert_same(pose @ pose.inverse(), SE3())
    assert_same(pose.inverse() @ pose, SE3())


@given(poses, poses)
def test_applying_a_product_is_applying_twice(a: SE3, b: SE3) -> None:
    points = np.array([[1.0, 2.0, 3.0], [-4.0, 0.0, 9.0]])
    np.testing.assert_allclose((a @ b).apply(points), a.apply(b.apply(points)), atol=1e-9)


@given(tangents())
def test_log_undoes_exp(tangent: Array) -> None:
    np.testing.assert_allclose(SE3.exp(tangent).log(), tangent, atol=1e-8)


@given(tangents())
def test_exp_is_gtsam_s(tangent: Array) -> None:
    np.testing.assert_allclose(SE3.exp(tangent).matrix, gtsam.Pose3.Expmap(tangent).matrix(), atol=1e-9)


@given(poses, poses)
def test_local_undoes_retract(a: SE3, b: SE3) -> None:
    assert_same(a.retract(a.local(b)), b, 1e-7)


@given(poses, tangents(1.0))
def test_the_adjoint_carries_a_perturbation_to_the_left(pose: SE3, tangent: Array) -> None:
    assert_same(pose @ SE3.exp(tangent), SE3.exp(pose.adjoint() @ tangent) @ pose, 1e-7)


@given(poses)
def test_quaternions_round_trip(pose: SE3) -> None:
    quaternion = pose.quaternion_xyzw
    assert quaternion[3] >= 0 and abs(np.linalg.norm(quaternion) - 1) < 1e-12
    assert_same(SE3.from_quaternion_xyzw(quaternion, pose.translation), pose)
    assert_same(SE3.from_quaternion_xyzw(-quaternion, pose.translation), pose)


@given(poses)
def test_the_angle_is_that_of_the_trace(pose: SE3) -> None:
    cosine = np.clip((np.trace(pose.rotation) - 1) / 2, -1, 1)
    assert abs(np.cos(pose.angle_rad) - cosine) < 1e-9
