"""Bookkeeping of what gives the metres."""

from __future__ import annotations

import pytest

from estimator.scale import BELIEF, NOMINAL_RIG, REAR_AXLE, ROAD, after_window, scale_evidence

FIRST = after_window({}, {ROAD: 300.0, REAR_AXLE: 60.0, BELIEF: 40.0})


def test_before_the_first_window_all_that_is_believed_comes_from_the_nominal_rig() -> None:
    assert FIRST == {ROAD: 300.0, REAR_AXLE: 60.0, NOMINAL_RIG: 40.0}


def test_an_earlier_belief_is_handed_on_to_the_sources_it_came_from() -> None:
    second = after_window(FIRST, {ROAD: 200.0, BELIEF: 400.0})
    assert second == pytest.approx({ROAD: 500.0, REAR_AXLE: 60.0, NOMINAL_RIG: 40.0})


def test_the_shares_sum_to_one_and_the_sigma_is_that_of_all_together() -> None:
    evidence = scale_evidence({ROAD: 9000.0, NOMINAL_RIG: 1000.0}, 0.0)
    assert evidence is not None
    assert sum(evidence.share.values()) == pytest.approx(1.0) and evidence.share[ROAD] == pytest.approx(0.9)
    assert evidence.sigma_percent == pytest.approx(1.0)


def test_no_amount_of_driving_beats_what_all_windows_share() -> None:
    evidence = scale_evidence({ROAD: 1e12}, 0.002)
    assert evidence is not None
    assert evidence.sigma_percent == pytest.approx(0.2) == evidence.common_sigma_percent


def test_without_a_window_nothing_is_said() -> None:
    assert scale_evidence({}, 0.002) is None
