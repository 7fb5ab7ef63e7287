"""A camera that seems far off along the way may have a late clock instead: both are said."""

from __future__ import annotations

from estimator.finding import FindingKind
from estimator.lens_config import LensConfig
from tests.watched_drives import LATE, STRAIGHT, watched

FAR = (0.0, 0.0, -0.04)


def test_a_shift_far_beyond_the_prior_is_told_with_the_clock_that_would_explain_it() -> None:
    (finding,) = watched(STRAIGHT, STRAIGHT, ahead_s=FAR).findings
    assert finding.kind is FindingKind.CLOCK_OFFSET and finding.cameras == ("left_rear",)
    assert finding.doubtful and "further on along the way" in finding.about
    assert "behind those of front would look the same" in finding.about


def test_a_shift_that_the_prior_allows_is_not_told() -> None:
    assert watched(STRAIGHT, STRAIGHT, ahead_s=LATE).findings == ()


def test_where_clocks_are_in_step_no_clock_is_suspected() -> None:
    in_step = LensConfig(clocks_in_step=True)
    assert watched(STRAIGHT, STRAIGHT, ahead_s=FAR, config=in_step).findings == ()


def test_however_far_the_shift_a_straight_does_not_tell_the_two_apart() -> None:
    (finding,) = watched(STRAIGHT, STRAIGHT, ahead_s=(0.0, 0.0, 0.08)).findings
    assert "further back along the way" in finding.about and "would look the same" in finding.about
