"""What tells the sides of the car from a plain prism: sill, mouldings, seams, handles, arches, window frames.

Side cameras look along the flank from a hand's breadth away, where a texture would blur to nothing. So each
part is the convex hull of a few points that stand a few millimetres off the body, once a side.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array

Rgba = tuple[float, float, float, float]
PAINT_RGBA: Rgba = (0.38, 0.10, 0.10, 1.0)
TRIM_RGBA: Rgba = (0.05, 0.05, 0.06, 1.0)
SATIN_RGBA: Rgba = (0.28, 0.28, 0.30, 1.0)

# Half width by height: of the doors, and of the windows above them.
DOORS_M = (
    (0.28, 0.81),
    (0.36, 0.838),
    (0.48, 0.854),
    (0.62, 0.860),
    (0.76, 0.854),
    (0.88, 0.838),
    (0.97, 0.80),
)
WINDOWS_M = ((0.97, 0.785), (1.45, 0.62))
_PROUD_M = 0.004
_SEAMS_M = (1.98, 0.86, -0.52)  # before the front door, between the doors, behind the rear one
_HANDLES_M = (1.02, -0.36)
_HANDLE_HEIGHT_M = 0.855
_ARCH_M = 0.40
_AXLE_HEIGHT_M = 0.32

Profile = tuple[tuple[float, float], ...]


@dataclass(frozen=True, eq=False)
class Detail:
    """A convex part of the left side; the right one is its mirror image.

    Attributes:
        name: Unique.
        points_m: (N, 3) in the ego frame.
        rgba: Color.
    """

    name: str
    points_m: Array
    rgba: Rgba


def flank_details() -> Iterator[Detail]:
    """Yield what is on the left side."""
    yield Detail("sill", _strip(DOORS_M, (-0.83, 2.14), (0.285, 0.37)), TRIM_RGBA)
    yield Detail("moulding", _strip(DOORS_M, (-0.80, 2.10), (0.56, 0.60), 0.014), TRIM_RGBA)
    yield Detail("waist", _strip(DOORS_M, (-0.82, 2.13), (0.945, 0.96), 0.006), SATIN_RGBA)
    for k, x in enumerate(_SEAMS_M):
        yield Detail(f"seam_{k}", _strip(DOORS_M, (x - 0.006, x + 0.006), (0.37, 0.94)), TRIM_RGBA)
    for k, x in enumerate(_HANDLES_M):
        yield Detail(f"handle_{k}", _handle(x), SATIN_RGBA)
    yield Detail("arch", _arch(0.0), TRIM_RGBA)
    yield Detail("pillar_b", _strip(WINDOWS_M, (0.80, 0.90), (0.97, 1.43)), PAINT_RGBA)
    yield Detail("pillar_c", _strip(WINDOWS_M, (-0.40, -0.30), (0.97, 1.42)), PAINT_RGBA)
    yield Detail("rail", _strip(WINDOWS_M, (-0.36, 1.44), (1.38, 1.44)), PAINT_RGBA)


def half_width_m(profile: Profile, z_m: Array | float) -> Array:
    """Return how far a side reaches from the car's middle at some heights."""
    heights, widths = np.array(profile).T
    return np.asarray(np.interp(z_m, heights, widths))


def _strip(
    profile: Profile, x_m: tuple[float, float], z_m: tuple[float, float], proud_m: float = _PROUD_M
) -> Array:
    """An upright rectangle that follows the curve of a side, a little off it."""
    between = [z for z, _ in profile if z_m[0] < z < z_m[1]]
    outer = [(x, half_width_m(profile, z) + proud_m, z) for x in x_m for z in (*z_m, *between)]
    inner = [(x, half_width_m(profile, z) - 0.02, z) for x in x_m for z in z_m]
    return np.array(outer + inner)


def _handle(x_m: float) -> Array:
    """A bar along the door, tapered towards it on all sides."""
    ends = ((0.10, 0.016, -0.005), (0.07, 0.009, 0.026))  # half length, half height, off the door
    return np.array(
        [
            (x_m + way * length, half_width_m(DOORS_M, _HANDLE_HEIGHT_M) + off, _HANDLE_HEIGHT_M + up * tall)
            for length, tall, off in ends
            for way in (-1, 1)
            for up in (-1, 1)
        ]
    )


def _arch(axle_x_m: float) -> Array:
    """The dark gap between a wheel and the body around it."""
    angles = np.linspace(0.0, np.pi, 11)
    x, z = axle_x_m + _ARCH_M * np.cos(angles), _AXLE_HEIGHT_M + _ARCH_M * np.sin(angles)
    outer = np.column_stack([x, half_width_m(DOORS_M, z) + _PROUD_M, z])
    return np.vstack([outer, outer - [0.0, 0.02, 0.0]])
