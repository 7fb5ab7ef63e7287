"""A facade as a value: a wall, its colours, and panels that stand out of or back from it.

Facade coordinates: x from the left corner as seen from the street, z up from the pavement, depth towards the
street. Later panels lie over earlier ones.
"""

from __future__ import annotations

from dataclasses import dataclass, field

Rgb = tuple[float, float, float]


@dataclass(frozen=True)
class Panel:
    """An upright rectangle of the facade at one depth.

    Attributes:
        x0, x1, z0, z1: Its edges in metres.
        depth_m: How far it stands out of the wall; negative is recessed.
        kind: What is painted on it.
    """

    x0: float
    x1: float
    z0: float
    z1: float
    depth_m: float
    kind: str


@dataclass(frozen=True)
class Facade:
    """Everything a builder and a painter need to know of a house front."""

    width_m: float
    height_m: float
    wall: str  # brick | plaster | ashlar | boards
    wall_color: Rgb
    trim_color: Rgb
    accent_color: Rgb
    muntins: int
    corner: bool
    panels: tuple[Panel, ...] = field(default=())
