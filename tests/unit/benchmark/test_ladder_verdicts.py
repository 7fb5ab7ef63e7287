"""Verdicts over several streets: what goes one way, what steps back, and what is only chance."""

import numpy as np
import pytest

from tests.benchmark.ladder_effects import Effect
from tests.benchmark.ladder_verdicts import REVERSES, verdict

EFFECT = Effect(
    "sensor.any",
    "",
    falls=("contrast_std", "klt_survival_1"),
    rises=("mean_level",),
    keeps=("gradient_mean",),
)
STREETS = np.array([[-6.0], [0.0], [6.0]])  # what differs between streets, but not between severities


@pytest.mark.parametrize(
    ("name", "ladder", "mark"),
    [
        ("contrast_std", [50, 45, 40, 30], ">"),
        ("contrast_std", [50, 45, 48, 30], REVERSES),
        ("contrast_std", [50, 50, 50, 50], REVERSES),
        ("contrast_std", [30, 40, 45, 50], REVERSES),
        ("mean_level", [30, 40, 45, 50], "<"),
        ("mean_level", [30, 45, 44.9, 50], "<"),
        ("klt_survival_1", [0.7, 0.69, 0.695, 0.6], ">"),
        ("gradient_mean", [10, 10.2, 9.9, 10], "="),
        ("gradient_mean", [10, 10.2, 9.0, 10], REVERSES),
        ("fast20_per_100kpx", [1, 9, 2, 8], "-"),
    ],
)
def test_a_ladder_leads_the_way_that_was_said(name: str, ladder: list[float], mark: str) -> None:
    assert verdict(name, np.array([ladder] * 3, float), EFFECT) == mark
    if name in ("mean_level", "contrast_std"):
        assert verdict(name, np.array([ladder] * 3, float) + STREETS, EFFECT) == mark


def test_a_step_back_on_one_street_of_three_is_chance_and_on_all_is_not() -> None:
    steady = np.array([50.0, 45.0, 40.0, 30.0])
    back = np.array([0.0, 0.0, 7.0, 0.0])
    one = np.array([steady, steady, steady + back])
    assert verdict("contrast_std", one, EFFECT) == ">"
    assert verdict("contrast_std", one + back, EFFECT) == REVERSES
