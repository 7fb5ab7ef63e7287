"""A house as a value: its walls, its colours, its roof, and panels that stand out of or back from the walls.

Wall coordinates: x from the left corner as seen from outside, z up from the pavement, depth outwards.
Later panels lie over earlier ones.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

Rgb = tuple[float, float, float]
RoofKind = Literal["gable", "hip", "flat"]
FLANK_M = 6.0  # width of a side wall in the texture; it is stretched over the depth of the house


@dataclass(frozen=True)
class Panel:
    """An upright rectangle of a wall at one depth.

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

    def shifted(self, x_m: float) -> Panel:
        """The same panel further right."""
        return Panel(self.x0 + x_m, self.x1 + x_m, self.z0, self.z1, self.depth_m, self.kind)


@dataclass(frozen=True)
class Roof:
    """A roof over the whole house.

    Attributes:
        kind: Ridge along the street with gables or hips at its ends, or flat.
        ridge_m: Height of the ridge above the eaves.
        chimneys: Where along the ridge chimneys stand, as shares of the width.
        dormers: Where dormers look out of the front, as shares of the width.
    """

    kind: RoofKind
    ridge_m: float
    chimneys: tuple[float, ...] = ()
    dormers: tuple[float, ...] = ()


@dataclass(frozen=True)
class Facade:
    """Everything a builder and a painter need to know of a house.

    Attributes:
        width_m, height_m: Of the front, up to the eaves.
        wall: Material: brick, plaster, ashlar, boards or render (smooth and clean).
        muntins: Bars across a window.
        panels: On the front.
        flanks: On the left, the right and the back wall, each ``FLANK_M`` wide and painted for itself; one
            for all three where nobody sees them.
        roof: What covers it.
        shop_name: What is written over the shop, if there is one; empty for any name.
    """

    width_m: float
    height_m: float
    wall: str
    wall_color: Rgb
    trim_color: Rgb
    accent_color: Rgb
    muntins: int
    panels: tuple[Panel, ...] = field(default=())
    flanks: tuple[tuple[Panel, ...], ...] = ((),)
    roof: Roof = Roof("flat", 0.05)
    shop_name: str = ""

    @property
    def walls_m(self) -> float:
        """Width of all walls side by side, as they lie in the texture."""
        return self.width_m + FLANK_M * len(self.flanks)

    def flank_m(self, side: int) -> float:
        """Where in the texture the left (0), right (1) or back (2) wall begins."""
        return self.width_m + FLANK_M * (side % len(self.flanks))

    @property
    def all_panels(self) -> tuple[Panel, ...]:
        """Those of every wall, where they lie in the texture."""
        sides = (panel.shifted(self.flank_m(k)) for k, flank in enumerate(self.flanks) for panel in flank)
        return (*self.panels, *sides)
