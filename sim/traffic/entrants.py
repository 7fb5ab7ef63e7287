"""Who moves on the tracks of one kind: how many, and of which models."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sim.seeds import rng_for
from sim.traffic.config import at_degree
from sim.traffic.flow import Entrant
from sim.traffic.model import Model
from sim.traffic.track import Track


def draw_entrants(
    kind: str,
    tracks: Sequence[Track],
    spacing_m: tuple[float, ...],
    degree: float,
    models: Sequence[Model],
    choices: Sequence[list[int]] | None,
    seed: int,
) -> tuple[list[Entrant], list[Model]]:
    """Draw who moves on each track; more of them at a higher degree, the first ones always the same.

    On one track a model comes again only after all others.
    """
    entrants, chosen = [], []
    for index, track in enumerate(tracks):
        rng = rng_for(seed, f"traffic.{kind}.{index}")
        spare = rng.random()
        count = int(track.ring_m / at_degree(spacing_m, degree) + spare) if degree else 0
        among = choices[index] if choices else list(range(len(models)))
        order: list[int] = []
        for number in range(count):
            if number % len(among) == 0:
                order += [among[k] for k in rng.permutation(len(among))]
            model = models[order[number]]
            brisk, jitter = float(np.clip(rng.normal(1.0, 0.1), 0.75, 1.3)), float(rng.uniform(-0.5, 0.5))
            entrants.append(Entrant(index, model.length_m, brisk, jitter))
            chosen.append(model)
    return entrants, chosen
