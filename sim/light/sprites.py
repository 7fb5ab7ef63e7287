"""Lamps as they are seen: small bright discs where nothing stands before them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sim.light.lamps import LightSource
from sim.light.surfaces import Floats
from sim.rendering.view import DepthImage, View

_LEAST_PX = 0.7  # what is smaller is drawn so large, and fainter
_BEHIND_M = 1.0  # a lamp shows through what is this much nearer: its own housing
_MARGIN = 4  # of the radius


def add_lamps(light: Floats, sources: Sequence[LightSource], view: View, depth_m: DepthImage) -> None:
    """Add the faces of lamps to a picture, in place."""
    pinhole = view.pinhole
    points_cam = view.world_from_cam.inverse().apply(
        np.array([one.position_m for one in sources]).reshape(-1, 3)
    )
    for source, point_cam in zip(sources, points_cam, strict=True):
        depth = float(point_cam[2])
        if depth < 0.3:
            continue
        u, v = (pinhole.focal_px[k] * point_cam[k] / depth + pinhole.center_px[k] for k in (0, 1))
        true_px = float(np.mean(pinhole.focal_px)) * source.radius_m / depth
        radius_px = max(true_px, _LEAST_PX)
        reach = _MARGIN * radius_px + 1
        if not (-reach < u < light.shape[1] + reach and -reach < v < light.shape[0] + reach):
            continue
        level = source.level * (true_px / radius_px) ** 2 * _towards(source, view)
        _add_disc(light, depth_m, (float(u), float(v)), radius_px, level, depth - _BEHIND_M)


def _towards(source: LightSource, view: View) -> float:
    """How much of the lamp's face turns to the camera; lamps with shields show little of it from afar."""
    ray = view.world_from_cam.translation - np.array(source.position_m)
    cosine = float(ray @ np.array(source.aim)) / float(np.linalg.norm(ray) + 1e-6)
    return float(np.clip(source.aside + 2.0 * cosine, 0.0, 1.0))


def _add_disc(
    light: Floats,
    depth_m: DepthImage,
    at_px: tuple[float, float],
    radius_px: float,
    level: float,
    depth: float,
) -> None:
    reach = int(_MARGIN * radius_px) + 2
    column, row = round(at_px[0]), round(at_px[1])
    rows = slice(max(0, row - reach), max(0, min(light.shape[0], row + reach + 1)))
    columns = slice(max(0, column - reach), max(0, min(light.shape[1], column + reach + 1)))
    v, u = np.ogrid[rows, columns]
    distance2 = (u - at_px[0]) ** 2 + (v - at_px[1]) ** 2
    shape = np.exp(-0.5 * (distance2 / radius_px**2) ** 1.5)  # flat in the middle, without a hard edge
    seen = depth_m[rows, columns] > depth
    light[rows, columns] += (level * shape * seen).astype(np.float32)
