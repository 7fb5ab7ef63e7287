"""Lamps: at a spacing along kerbs, on alternate sides; what night lights the street with."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from sim.shapes.furniture import LAMP_HEAD_M
from sim.streets.catalogue import Catalogue
from sim.streets.placing import TO_STREET, KerbSite

SPACING_M = 27.0  # on each side, so that one comes every thirteen metres of street
_FIRST_M, _APART_M = 5.0, 9.0
_SHIFTS_M = (0.0, 1.2, -1.2, 2.4, -2.4, 5.0, -5.0, 8.0)


@dataclass(frozen=True)
class Lamp:
    """A source of light that belongs to the street.

    Attributes:
        position_m: World position of what shines.
        aim: Unit vector of the middle of its beam.
        kind: What it is: over a street, under the ceiling of a tunnel, or on a high mast.
    """

    position_m: tuple[float, float, float]
    aim: tuple[float, float, float]
    kind: Literal["street", "tunnel", "mast"]


def line_with_lamps(street: KerbSite, catalogue: Catalogue, others: Sequence[Lamp]) -> list[Lamp]:
    """Stand lamps along a kerb, not next to any other across a narrow street; return what shines."""
    kerb, lamps = street.kerb, list[Lamp]()
    first_m = _FIRST_M + (0.0 if kerb.side > 0 else SPACING_M / 2)
    for s in street.steps(first_m, SPACING_M):
        for shift in _SHIFTS_M:
            lamp = _lamp(street, float(s + shift))
            alone = all(
                math.dist(lamp.position_m, other.position_m) > _APART_M for other in (*others, *lamps)
            )
            if alone and street.put(catalogue.lamp, s + shift, 0.4, TO_STREET):
                lamps.append(lamp)
                break
    return lamps


def _lamp(street: KerbSite, s_m: float) -> Lamp:
    path = street.kerb.path
    foot = path.point_m(s_m, 0.4)
    yaw = float(path.heading_rad(s_m)) + TO_STREET
    reach, height = LAMP_HEAD_M
    x, y = foot + reach * np.array([np.cos(yaw), np.sin(yaw)])
    ground = float(street.site.relief.height_m(foot)) + street.kerb.height_m
    return Lamp((float(x), float(y), ground + height), (0.0, 0.0, -1.0), "street")
