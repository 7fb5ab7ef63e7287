"""Settings that the command line hands to an estimator."""

from __future__ import annotations

import re

import pytest

from estimator.batch import BatchConfig, BatchEstimator
from estimator.errors import InputError
from estimator.online import OnlineEstimator
from eval.estimator_settings import is_of_estimator, with_settings
from tests.mounts import left_side_rig

RIG = left_side_rig()


def test_settings_reach_the_estimator() -> None:
    settings = ["drive.speed_mps=8", "estimator.refine=intrinsics", "estimator.pace.keyframes=12"]
    estimator = with_settings("online", OnlineEstimator, settings)(RIG)
    assert isinstance(estimator, OnlineEstimator)
    assert estimator.config.refine == "intrinsics" and estimator.config.pace.keyframes == 12


def test_without_settings_of_its_own_the_estimator_is_what_it_was() -> None:
    assert with_settings("online", OnlineEstimator, ["drive.speed_mps=8"]) is OnlineEstimator


def test_the_batch_estimator_refines_what_its_online_part_does() -> None:
    estimator = with_settings("batch", BatchEstimator, ["estimator.refine=both"])(RIG)
    assert isinstance(estimator, BatchEstimator) and isinstance(estimator.config, BatchConfig)
    assert estimator._online.config.refine == "both"


@pytest.mark.parametrize(
    ("setting", "complaint"),
    [
        ("estimator.refin=none", r"--set estimator.refin: unknown key; there are: .*did you mean 'refine'"),
        ("estimator.refine=lenses", r"--set estimator.refine: got 'lenses', wanted 'none', 'intrinsics'"),
        ("estimator.pace.keyframes=ten", r"--set estimator.pace.keyframes: got 'ten', wanted an integer"),
        ("estimator.=1", r"wanted KEY=VALUE"),
    ],
)
def test_a_wrong_setting_is_refused_with_its_path(setting: str, complaint: str) -> None:
    with pytest.raises(InputError, match=complaint):
        with_settings("online", OnlineEstimator, [setting])


def test_an_estimator_without_settings_says_so() -> None:
    message = re.escape("--set estimator.refine=both: estimator 'mine' takes no settings")
    with pytest.raises(InputError, match=message):
        with_settings("mine", lambda rig: OnlineEstimator(rig), ["estimator.refine=both"])


def test_only_keys_that_begin_with_estimator_are_the_estimator_s() -> None:
    assert is_of_estimator(" estimator.refine=both") and not is_of_estimator("estimators.refine=both")
