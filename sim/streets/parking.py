"""Where cars are parked, and which."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from estimator.se3 import Array
from sim.shapes.parked_cars import KINDS, CarKind, car_mesh, car_skin, outline_m, varied
from sim.streets.network import Bay
from sim.streets.placing import Site, Thing
from sim.streets.scenery import Prop, Skin

MODELS = 48


@dataclass(frozen=True, eq=False)
class Model:
    """A car that may be parked here; it is painted only if it is."""

    kind: CarKind
    thing: Thing
    paint: np.random.Generator


def draw_cars(rng: np.random.Generator) -> list[Model]:
    """Draw the cars that are parked around here, each with its own make, paint and number plate."""
    models = []
    for k, stream in enumerate(rng.spawn(MODELS)):
        kind = varied(KINDS[stream.integers(len(KINDS))], stream)
        models.append(Model(kind, Thing(car_mesh(kind), f"car_{k}", outline_m(kind)), stream.spawn(1)[0]))
    return models


def paint_cars(models: Sequence[Model], parked: Iterable[Prop]) -> dict[str, Skin]:
    """Paint those models that stand somewhere."""
    worn = {prop.skin for prop in parked}
    here = [model for model in models if model.thing.skin in worn]
    return {model.thing.skin: car_skin(model.kind, model.paint) for model in here}


def park(
    site: Site, bays: Sequence[Bay], models: Sequence[Model], share: float, rng: np.random.Generator
) -> None:
    """Fill a share of the bays.

    Which bay is taken first, by which car, does not depend on the share.
    """
    taken = rng.random(len(bays))
    off_m, turns = rng.normal(0, (0.12, 0.05), (len(bays), 2)), rng.normal(0, 0.02, len(bays))
    around = rng.random(len(bays)) < 0.4
    centers_m = np.array([bay.center_m for bay in bays]).reshape(-1, 2)
    chosen = choose_cars(centers_m, np.argsort(taken), len(models))
    for k, bay in enumerate(bays):
        yaw = bay.yaw_rad + turns[k] + (np.pi if bay.is_across and around[k] else 0.0)
        ahead = np.array([np.cos(bay.yaw_rad), np.sin(bay.yaw_rad)])
        at = centers_m[k] + off_m[k, 0] * ahead + off_m[k, 1] * np.array([-ahead[1], ahead[0]])
        site.put_at(models[chosen[k]].thing, at, float(yaw), shown=bool(taken[k] < share))


def choose_cars(centers_m: Array, order: NDArray[np.intp], models: int) -> NDArray[np.intp]:
    """Choose a car for each bay: one not seen yet, and after the last of them the one whose like is farthest.

    Args:
        centers_m: (N, 2) of the bays.
        order: (N,) in which they are taken; who comes later changes nothing for who came before.
        models: How many there are.

    Returns:
        (N,) index of a model.
    """
    chosen = np.zeros(len(centers_m), np.intp)
    nearest_m = np.full((len(centers_m), models), np.inf)  # from each bay to the nearest car of each model
    for bay in order:
        chosen[bay] = np.argmax(nearest_m[bay])
        apart_m = np.linalg.norm(centers_m - centers_m[bay], axis=1)
        nearest_m[:, chosen[bay]] = np.minimum(nearest_m[:, chosen[bay]], apart_m)
    return chosen
