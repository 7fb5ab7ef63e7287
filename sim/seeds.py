"""One seed, spawned by purpose, so that turning one knob does not reshuffle the rest."""

from __future__ import annotations

import hashlib

import numpy as np


def rng_for(seed: int, purpose: str) -> np.random.Generator:
    """Return the generator of one purpose, such as ``street`` or ``sensor.rear.17``.

    Depends on nothing but its arguments: not on which generators were made before, nor in which process.
    """
    digest = hashlib.sha256(purpose.encode()).digest()
    words = np.frombuffer(digest, dtype="<u4").tolist()
    return np.random.default_rng(np.random.SeedSequence(seed, spawn_key=tuple(words)))
