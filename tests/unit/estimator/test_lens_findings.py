"""Accusations need clear evidence that matters."""

from __future__ import annotations

import numpy as np
import pytest

from estimator.evidence import Posterior
from estimator.lens_findings import AccusationConfig, accusations
from estimator.unknowns import Unknowns
from tests.mounts import left_side_rig

RIG = left_side_rig()
UNKNOWNS = Unknowns(RIG)
LENS, CLOCK = UNKNOWNS.lens(1), UNKNOWNS.clock(2)


def told(row: int, value: float, sigma: float, disagreement: float = 1.0) -> list[str]:
    """Return what is told where one unknown is off."""
    mean, sigmas = np.zeros(UNKNOWNS.size), np.full(UNKNOWNS.size, 1e-6)
    mean[row], sigmas[row] = value, sigma
    posterior = Posterior(mean, np.diag(sigmas**2), disagreement)
    return [finding.about for finding in accusations(posterior, RIG, AccusationConfig())]


@pytest.mark.parametrize(
    ("row", "value", "sigma", "about"),
    [
        (LENS.start, -0.012, 0.001, "left_front: focal length 1.20 +- 0.10 % shorter than the rig file says"),
        (LENS.start + 2, 2.0, 0.2, "principal point off by (0.0, 2.0) +- 0.2 px"),
        (CLOCK, -0.01, 0.001, "left_rear: stamps 10.0 +- 1.0 ms behind those of front"),
    ],
)
def test_what_is_clear_and_matters_is_told(row: int, value: float, sigma: float, about: str) -> None:
    (text,) = told(row, value, sigma)
    assert about in text


@pytest.mark.parametrize(("row", "value"), [(LENS.start, 0.012), (LENS.start + 2, 2.0), (CLOCK, 0.01)])
def test_what_is_not_clear_is_not_told(row: int, value: float) -> None:
    assert told(row, value, value / 5) == []
    assert told(row, value, value / 10, disagreement=4.0) == []
    assert told(row, value, value / 20, disagreement=4.0) != []


@pytest.mark.parametrize(("row", "value"), [(LENS.start, 0.002), (LENS.start + 2, 0.8), (CLOCK, 0.002)])
def test_what_does_not_matter_is_not_told(row: int, value: float) -> None:
    assert told(row, value, 1e-6) == []
