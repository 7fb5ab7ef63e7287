"""Wrong lenses and late clocks are told rightly, and only where the drive shows them."""

from __future__ import annotations

import numpy as np
import pytest

from estimator.finding import FindingKind
from estimator.lens_watch import Refine
from estimator.unknowns import Unknowns
from tests.mounts import worst_error
from tests.watched_drives import BEND, LATE, NOMINAL, STRAIGHT, watched

UNKNOWNS = Unknowns(NOMINAL)
LONGER = np.zeros(UNKNOWNS.size)
LONGER[UNKNOWNS.lens(1)] = [np.log(1.015), 3.0, -2.0]


def test_nobody_is_accused_where_all_is_right() -> None:
    assert watched(STRAIGHT, BEND).findings == ()


def test_a_wrong_lens_is_told_with_its_figures() -> None:
    watch = watched(BEND, STRAIGHT, unknowns=LONGER)
    (finding,) = watch.findings
    assert finding.kind is FindingKind.WRONG_INTRINSICS and finding.cameras == ("left_front",)
    assert finding.doubtful and "longer than the rig file says" in finding.about
    np.testing.assert_allclose(float(finding.about.split()[3]), 1.5, atol=0.2)
    assert watch.lenses == {}


@pytest.mark.parametrize("refine", ["intrinsics", "both"])
def test_a_wrong_lens_is_corrected_with_its_pose_where_asked(refine: Refine) -> None:
    watch = watched(BEND, STRAIGHT, unknowns=LONGER, refine=refine)
    lens, stated = watch.lenses["left_front"], NOMINAL["left_front"].camera
    assert abs(lens.focal_px[0] / stated.focal_px[0] / 1.015 - 1) < 0.002
    np.testing.assert_allclose(np.subtract(lens.center_px, stated.center_px), [3.0, -2.0], atol=0.5)
    rotation_deg, translation_mm = worst_error(watch.belief.rig, NOMINAL)
    assert rotation_deg < 0.1 and translation_mm < 30
    assert not watch.findings[0].doubtful


def test_on_a_steady_drive_a_late_clock_looks_like_a_shift_and_nobody_is_accused() -> None:
    assert watched(STRAIGHT, STRAIGHT, ahead_s=LATE).findings == ()


def test_a_late_clock_is_told_once_the_car_turns() -> None:
    (finding,) = watched(STRAIGHT, BEND, ahead_s=LATE).findings
    assert finding.kind is FindingKind.CLOCK_OFFSET and finding.cameras == ("left_rear",)
    assert finding.about.endswith("ahead of those of front")
    np.testing.assert_allclose(float(finding.about.split()[2]), 20.0, atol=2.0)


def test_a_late_clock_is_corrected_with_the_pose_where_asked() -> None:
    watch = watched(STRAIGHT, BEND, STRAIGHT, ahead_s=LATE, refine="clocks")
    assert abs(watch.belief.ahead_s["left_rear"] - 0.02) < 0.002
    rotation_deg, translation_mm = worst_error(watch.belief.rig, NOMINAL)
    assert rotation_deg < 0.1 and translation_mm < 15
