"""Moved cameras: noticed, missed, and called wrongly."""

import pytest

from estimator.estimate import Status
from eval.metric import Missing
from eval.metrics_alarm import alarm_metrics
from tests.unit.eval.tiny_run import TRUE_POSES, off_by, run_log, straight, truth_of

KNOCKED = {"rear": TRUE_POSES["rear"].retract(off_by(0.5, 0))}


def alarms(moved_at: dict[str, set[int]], moves=(), count=12):
    path = straight(count)
    statuses_at = lambda index: {name: Status.MOVED for name, when in moved_at.items() if index in when}  # noqa: E731
    return alarm_metrics(run_log(path, statuses_at=statuses_at), truth_of(path, moves))


def test_delay_is_the_time_from_the_move_to_the_status():
    values = alarms({"rear": {8, 9, 10, 11}}, [(5, KNOCKED)])
    assert values["alarm.delay_s"] == pytest.approx(0.3)
    assert values["alarm.missed_count"] == 0
    assert values["alarm.false_count"] == 0


def test_a_move_without_an_answer_is_missed():
    values = alarms({}, [(5, KNOCKED)])
    assert values["alarm.missed_count"] == 1
    assert values["alarm.delay_s"] == Missing("no move was noticed")


def test_an_alarm_before_the_move_or_of_another_camera_is_false():
    values = alarms({"rear": {3}, "left": {7}}, [(5, KNOCKED)])
    assert values["alarm.false_count"] == 2
    assert values["alarm.missed_count"] == 1


def test_a_second_alarm_for_one_move_is_false():
    assert alarms({"rear": {6, 9}}, [(5, KNOCKED)])["alarm.false_count"] == 1


def test_on_a_drive_without_moves_only_false_alarms_have_a_count():
    values = alarms({"left": {2}})
    assert values["alarm.false_count"] == 1
    assert values["alarm.delay_s"] == values["alarm.missed_count"] == Missing("no camera moved in this drive")


def test_a_move_too_small_to_matter_is_none():
    tiny = {"rear": TRUE_POSES["rear"].retract(off_by(0.05, 5))}
    assert alarms({}, [(5, tiny)])["alarm.missed_count"] == Missing("no camera moved in this drive")
