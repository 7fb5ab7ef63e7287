"""Cameras that are knocked while the car drives: told, named, and learnt again."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache

import numpy as np
import pytest

from estimator.bundle import FrameBundle
from estimator.estimate import Estimate, Status
from estimator.finding import FindingKind
from estimator.online import OnlineEstimator
from estimator.se3 import SE3
from tests.canyon import render
from tests.canyon_drive import IN_STEP, NOMINAL, PERIOD_NS, TRUTH, rig_of
from tests.mounts import worst_error

PATH = [SE3(np.eye(3), np.array([0.7 * index - 8.0, 0.0, 0.0])) for index in range(38)]
KNOCK = SE3.exp(np.array([0.0, np.deg2rad(0.5), 0.0, 0.01, 0.0, 0.0]))
AT = 17


def knocked_bundles(struck: str) -> list[FrameBundle]:
    """Return a straight drive on which a camera is knocked at ``AT``."""
    after = TRUTH[struck].ego_from_cam @ KNOCK
    return [
        FrameBundle(
            index * PERIOD_NS,
            {
                name: render(
                    mounted.camera,
                    pose @ (after if name == struck and index >= AT else mounted.ego_from_cam),
                )
                for name, mounted in TRUTH.cameras.items()
            },
        )
        for index, pose in enumerate(PATH)
    ]


@cache
def answers(struck: str) -> Sequence[Estimate]:
    """Return the answers to every bundle and the last one."""
    estimator = OnlineEstimator(NOMINAL, IN_STEP)
    return [*map(estimator.update, knocked_bundles(struck)), estimator.close()]


@pytest.mark.usefixtures("one_thread")
class TestKnockedCamera:
    """One camera is knocked by half a degree and a centimetre."""

    def test_it_is_suspect_before_it_is_known_to_have_moved(self) -> None:
        told = [answer.cameras["left_rear"].status for answer in answers("left_rear")]
        assert told[AT - 1] is Status.CONVERGED and Status.SUSPECT in told[AT:]
        contradicted = [a for a in answers("left_rear") if a.cameras["left_rear"].status is Status.SUSPECT]
        assert all(f.kind is FindingKind.CONTRADICTED for a in contradicted for f in a.findings)

    def test_its_new_pose_is_learnt_and_the_move_stays_told(self) -> None:
        last = answers("left_rear")[-1]
        knocked = TRUTH.with_extrinsics({"left_rear": TRUTH["left_rear"].ego_from_cam @ KNOCK})
        rotation_deg, translation_mm = worst_error(rig_of(last), knocked)
        assert rotation_deg < 0.05 and translation_mm < 15
        assert [(f.kind, f.cameras) for f in last.findings] == [(FindingKind.MOVED_CAMERA, ("left_rear",))]
        assert re.search(
            r"moved on the car by 0\.(49|50|51) deg and 1\d mm at about 1\.\d s", last.findings[0].about
        )

    def test_no_other_camera_is_accused_or_spoilt(self) -> None:
        named = {name for a in answers("left_rear") for f in a.findings for name in f.cameras}
        assert named == {"left_rear"}
        assert answers("left_rear")[-1].cameras["left_front"].status is Status.CONVERGED


@pytest.mark.usefixtures("one_thread")
def test_a_knocked_reference_puts_every_camera_in_doubt() -> None:
    last = answers("front")[-1]
    assert [(f.kind, f.cameras) for f in last.findings] == [(FindingKind.CONTRADICTED, ("front",))]
    assert {camera.status for camera in last.cameras.values()} == {Status.SUSPECT}
