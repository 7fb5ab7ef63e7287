"""A pinhole view as the frustum that OpenGL-like cameras want: its edges on the near plane."""

from __future__ import annotations

from dataclasses import dataclass

from estimator.camera import Camera
from sim.rendering.view import NEAR_M


@dataclass(frozen=True)
class Frustum:
    """Where the image's borders lie on the near plane, in metres; x to the right, y up.

    The left edge is ``center_m - half_width_m``; the principal point may lie outside.
    """

    center_m: float
    half_width_m: float
    bottom_m: float
    top_m: float


def frustum_of(pinhole: Camera) -> Frustum:
    """Return the frustum of a pinhole camera's whole image."""
    left_m, right_m = (_edge_m(pinhole, 0, edge_px) for edge_px in (-0.5, pinhole.size_px[0] - 0.5))
    top_m, bottom_m = (_edge_m(pinhole, 1, edge_px) for edge_px in (-0.5, pinhole.size_px[1] - 0.5))
    return Frustum((left_m + right_m) / 2, (right_m - left_m) / 2, -bottom_m, -top_m)


def _edge_m(pinhole: Camera, axis: int, edge_px: float) -> float:
    return NEAR_M * (edge_px - pinhole.center_px[axis]) / pinhole.focal_px[axis]
