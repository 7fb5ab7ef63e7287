from __future__ import annotations

import numpy as np
import pytest

from sim.sensing.sensor import LEVELS_PER_ELECTRON, READ_NOISE_LEVELS, expose

ROUNDING_VARIANCE = 1 / 12


@pytest.mark.parametrize("level", [20.0, 120.0, 200.0])
@pytest.mark.parametrize("strength", [0.5, 1.0, 3.0])
def test_noise_has_the_mean_and_variance_of_shot_and_read_noise(level: float, strength: float) -> None:
    image = expose(np.full((300, 400), level, np.float32), strength, np.random.default_rng(0))
    variance = strength**2 * (level * LEVELS_PER_ELECTRON + READ_NOISE_LEVELS**2) + ROUNDING_VARIANCE
    assert image.mean() == pytest.approx(level, abs=0.05)
    assert image.var() == pytest.approx(variance, rel=0.03)


def test_no_noise_only_rounds() -> None:
    light = np.array([[0.4, 0.6, 254.6, 300.0, -3.0]], np.float32)
    assert expose(light, 0.0, np.random.default_rng(0)).tolist() == [[0, 1, 255, 255, 0]]


def test_same_generator_state_same_image() -> None:
    light = np.full((4, 5), 100, np.float32)
    first, second = (expose(light, 1.0, np.random.default_rng(5)) for _ in range(2))
    assert first.tobytes() == second.tobytes()
