from __future__ import annotations

import numpy as np

from sim.seeds import rng_for


def test_same_seed_and_purpose_give_the_same_numbers() -> None:
    assert np.array_equal(rng_for(3, "street").random(5), rng_for(3, "street").random(5))


def test_purposes_and_seeds_are_independent() -> None:
    draws = [
        rng_for(seed, purpose).random()
        for seed in range(4)
        for purpose in ("street", "drive", "sensor.rear.1")
    ]
    assert len(set(draws)) == 12
