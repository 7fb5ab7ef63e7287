"""Settings that the command line hands to an estimator."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from estimator.batch import BatchConfig, BatchEstimator
from estimator.errors import InputError
from estimator.online import OnlineEstimator
from eval.estimator_settings import is_of_estimator, with_settings
from tests.mounts import left_side_rig
from tests.settings import Setting, all_settings

RIG = left_side_rig()


def test_settings_reach_the_estimator() -> None:
    settings = ["drive.speed_mps=8", "estimator.refine=intrinsics", "estimator.pace.keyframes=12"]
    estimator = with_settings("online", OnlineEstimator, settings)(RIG)
    assert isinstance(estimator, OnlineEstimator)
    assert estimator.config.refine == "intrinsics" and estimator.config.pace.keyframes == 12


@pytest.mark.parametrize("factory", [OnlineEstimator, BatchEstimator], ids=["online", "batch"])
@pytest.mark.parametrize("setting", list(all_settings(BatchConfig)), ids=lambda setting: setting.path)
def test_a_setting_changes_nothing_but_itself(
    factory: type[OnlineEstimator] | type[BatchEstimator], setting: Setting
) -> None:
    path = setting.path if factory is BatchEstimator else setting.path.removeprefix("online.")
    default = value_at(factory.config_type().model_dump(), path)
    if not isinstance(default, int | float | str):
        pytest.skip("no single value, or no setting of this estimator")
    chosen = with_settings("it", factory, [f"estimator.{path}={default}"])(RIG)
    assert isinstance(chosen, OnlineEstimator | BatchEstimator)
    assert chosen.config == factory.config_type()


def value_at(tree: Any, path: str) -> Any:
    for part in path.split("."):
        tree = tree.get(part) if isinstance(tree, dict) else None
    return tree


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


def test_the_readme_names_settings_that_exist_with_their_defaults() -> None:
    text = (Path(__file__).parents[3] / "README.md").read_text()
    table = (
        text.partition("What a recording of your own should be told")[2]
        .partition("\n\n")[2]
        .partition("\n\n")[0]
    )
    keys = re.findall(r"\| `([a-z_.]+)`[^|]*\| ([^:;,| ]+)", table)
    assert len(keys) == 4
    for key, default in keys:
        assert str(value_at(OnlineEstimator.config_type().model_dump(), key)).lower() == default
