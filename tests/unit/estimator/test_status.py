"""Status: sure only where sigma, links and prior all agree."""

from __future__ import annotations

import numpy as np
import pytest

from estimator.belief import Belief
from estimator.camera import Camera
from estimator.estimate import ALL_AXES, Axes, Status
from estimator.off_nominal import OffNominal
from estimator.rig import MountedCamera, Rig
from estimator.se3 import SE3
from estimator.status import StatusConfig, judge

CAMERA = Camera("pinhole", (640, 400), (320.0, 320.0), (319.5, 199.5))
NOMINAL = Rig("front", {name: MountedCamera(CAMERA, SE3()) for name in ("front", "rear")})


def status(
    *,
    moved_m: float = 0.05,
    sigma: float = 1e-4,
    links: int = 500,
    missed_bundles: int = 0,
    newest: int = 500,
    observed: Axes = ALL_AXES,
) -> Status:
    moved = SE3(np.eye(3), np.array([moved_m, 0.0, 0.0]))
    belief = Belief(NOMINAL.with_extrinsics({"rear": moved}), sigma**2 * np.eye(6))
    return judge(
        "rear", belief, NOMINAL, links, newest, missed_bundles, StatusConfig(), observed, OffNominal()
    )


def test_a_sure_linked_camera_near_its_prior_has_converged() -> None:
    assert status() == Status.CONVERGED


@pytest.mark.parametrize("flaw", [{"sigma": 0.01}, {"links": 3}])
def test_a_camera_without_enough_evidence_is_weak(flaw: dict[str, float]) -> None:
    assert status(**flaw) == Status.WEAK  # type: ignore[arg-type]


def test_a_camera_with_an_axis_that_only_the_prior_knows_is_weak() -> None:
    assert status(observed=(True, True, True, True, True, False)) == Status.WEAK


def test_an_answer_that_belongs_to_another_rig_is_weak_however_small_its_sigma() -> None:
    assert status(moved_m=0.9) == Status.WEAK
    assert status(moved_m=0.4) == Status.CONVERGED


@pytest.mark.parametrize("flaw", [{"missed_bundles": 50}, {"newest": 3}])
def test_a_camera_without_images_or_in_which_nothing_is_recognised_is_lost(flaw: dict[str, int]) -> None:
    assert status(**flaw) == Status.LOST  # type: ignore[arg-type]
