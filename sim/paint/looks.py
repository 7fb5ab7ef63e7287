"""What a person wears, drawn by seed: it decides both the shape of the body and its paint."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

Top = Literal["shirt", "striped", "jacket", "hoodie"]
Hair = Literal["short", "long", "bald"]
_TOPS_WORN: tuple[Top, ...] = ("shirt", "striped", "jacket", "hoodie")
_HAIR_WORN: tuple[Hair, ...] = ("short", "short", "long", "long", "bald")


@dataclass(frozen=True)
class Look:
    """What a person wears; what changes the shape as well as the paint."""

    top: Top
    hair: Hair
    hat: bool
    coat: bool
    bag: bool


def draw_look(rng: np.random.Generator, rides: bool = False) -> Look:
    """Draw what somebody wears today; coats do not go with bicycles, and helmets stand in for hats."""
    top, hair = _TOPS_WORN[rng.integers(4)], _HAIR_WORN[rng.integers(5)]
    hat, coat, bag = rng.random(3) < (0.6 if rides else 0.25, 0.0 if rides else 0.3, 0.45)
    return Look(top, hair, bool(hat), bool(coat), bool(bag))
