"""Every setting of the estimators has a range: within it they answer, beyond it the value is refused."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any, get_args

import pytest
from annotated_types import Ge, Gt, Le, Lt
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import ValidationError

import estimator
from estimator.batch import BatchConfig
from estimator.config_error import describe_first_error
from estimator.online import OnlineEstimator
from estimator.online_config import OnlineConfig
from tests.canyon_drive import NOMINAL, canyon_bundles
from tests.settings import Setting, all_settings

NUMBERS = {s.path: s for model in (OnlineConfig, BatchConfig) for s in all_settings(model) if s.is_number}
ONLINE = [setting for setting in all_settings(OnlineConfig) if setting.is_number]
BUNDLES = canyon_bundles()[:6]
QUICK = {  # every bundle a keyframe, and a window of few with few tracks
    "front_end.tracker.max_points": 110,
    "window.result.min_inliers": 30,
    "pace.spacing_m": 0.5,
    "pace.first_keyframes": 4,
    "pace.keyframes": 3,
}


def nested(values: dict[str, Any]) -> dict[str, Any]:
    """Return settings by dotted path as groups within groups."""
    tree: dict[str, Any] = {}
    for path, value in values.items():
        *groups, key = path.split(".")
        group = tree
        for name in groups:
            group = group.setdefault(name, {})
        group[key] = value
    return tree


def bounds(marks: Any) -> int:
    """Count the ends of a range: 2 for one that has both."""
    return sum(isinstance(mark, kinds) for mark in marks for kinds in ((Ge, Gt), (Le, Lt)))


def test_the_walk_finds_settings_of_every_depth() -> None:
    assert {"online.window.graph.rear_axle.floor", "window.handover.view.max_norm"} <= set(NUMBERS)
    assert len(ONLINE) > 120


@pytest.mark.parametrize("path", NUMBERS)
def test_every_number_has_a_range_at_both_ends(path: str) -> None:
    assert bounds(NUMBERS[path].field.metadata) == 2


SOURCES = "\n".join(path.read_text() for path in Path(estimator.__path__[0]).glob("*.py"))


@pytest.mark.parametrize("path", [setting.path for setting in all_settings(BatchConfig)])
def test_every_setting_is_read_somewhere(path: str) -> None:
    name = path.rpartition(".")[2]
    assert re.search(rf"\.{name}\b", SOURCES) or f'"{name}"' in SOURCES


def test_the_defaults_lie_within() -> None:
    assert BatchConfig.model_validate(BatchConfig().model_dump()) == BatchConfig()


def test_every_number_of_a_list_has_a_range_too() -> None:
    lists = [s for s in all_settings(BatchConfig) if getattr(s.kinds[0], "__origin__", None) is tuple]
    assert lists
    for setting in lists:
        item = get_args(setting.kinds[0])[0]
        assert bounds(item.__metadata__[0].metadata) == 2, setting.path


@pytest.mark.parametrize(
    ("path", "value", "told"),
    [
        ("front_end.tracker.flow.window_px", 2, "got 2, wanted 3 to 101"),
        ("front_end.tracker.detect.cells", 0, "got 0, wanted 1 to 100000"),
        ("lens.usual.clock_s", 0.0, "got 0.0, wanted 1e-06 to 1"),
        ("ledger.shared_scale_sigma", -0.1, "got -0.1, wanted 0 to 1"),
    ],
)
def test_a_number_out_of_range_is_refused_with_path_and_range(path: str, value: float, told: str) -> None:
    with pytest.raises(ValidationError) as error:
        OnlineConfig.model_validate(nested({path: value}))
    assert describe_first_error(error.value, OnlineConfig) == f"{path}: {told}"


def drive(values: dict[str, Any]) -> OnlineEstimator:
    driven = OnlineEstimator(NOMINAL, OnlineConfig.model_validate(nested(QUICK | values)))
    for bundle in BUNDLES:
        driven.update(bundle)
    driven.close()
    return driven


def test_the_drive_is_long_enough_to_learn_from() -> None:
    assert drive({}).has_learnt


def values(setting: Setting) -> st.SearchStrategy[float]:
    """Draw from a range, with its ends and what lies near the default."""
    usual, high = setting.field.default, setting.high
    low = setting.low if any(isinstance(mark, Ge) for mark in setting.field.metadata) else usual / 1000
    assert low is not None and high is not None
    ends = st.sampled_from([low, high, max(low, usual / 2), min(high, usual * 2)])
    if setting.kinds[0] is int:
        return ends.map(int) | st.integers(int(low), int(high))
    return ends | st.floats(low, high)


@settings(max_examples=6)
@given(st.sampled_from(ONLINE).flatmap(lambda setting: st.tuples(st.just(setting.path), values(setting))))
def test_whatever_a_setting_is_within_its_range_there_is_an_answer(chosen: tuple[str, float]) -> None:
    drive(dict([chosen]))
