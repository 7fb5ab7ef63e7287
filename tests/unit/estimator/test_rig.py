"""Rigs as values."""

from __future__ import annotations

import numpy as np
import pytest

from estimator.errors import InputError
from estimator.rig import Rig, RigPrior
from estimator.se3 import SE3
from tests.bags import small_rig


def test_the_reference_must_be_a_camera() -> None:
    with pytest.raises(InputError, match="'roof' is not in the rig; cameras: front, left, rear"):
        Rig("roof", small_rig().cameras)


def test_an_unknown_camera_is_told_with_what_there_is() -> None:
    with pytest.raises(InputError, match="'rear2' is not in the rig; cameras: front, left, rear"):
        small_rig()["rear2"]


def test_all_but_the_reference_are_estimated() -> None:
    assert small_rig().estimated_names == ("left", "rear")


def test_moving_a_camera_leaves_the_others() -> None:
    rig, moved = small_rig(), SE3(np.eye(3), np.ones(3))
    other = rig.with_extrinsics({"rear": moved})
    assert other["rear"].ego_from_cam is moved
    assert other["left"] is not rig["rear"] and other["left"].ego_from_cam is rig["left"].ego_from_cam
    assert rig["rear"].ego_from_cam is not moved


def test_the_prior_s_norms_become_sigmas_per_axis() -> None:
    sigma = np.sqrt(np.diag(RigPrior(rotation_deg=3.0, translation_mm=100.0).covariance))
    assert np.linalg.norm(sigma[:3]) == pytest.approx(np.deg2rad(3.0))
    assert np.linalg.norm(sigma[3:]) == pytest.approx(0.1)
