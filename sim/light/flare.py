"""Light that goes astray in a lens: the sun's veil, its star and its ghosts, and the halos of lamps at night.

``mark_sun`` makes the sun's disc far brighter than anything else is; what of it is left once things stand
before it and the lens has bent it tells the flare where the sun is, and how much of it. ``Flare.over`` then
leaves it as bright as clouds let it be.
"""

from __future__ import annotations

import cv2
import numpy as np

from estimator.camera import Camera
from estimator.se3 import Array
from sim.light.sky import SUN_RADIUS_DEG
from sim.light.surfaces import Floats
from sim.light.weather import Ladder, on_ladder
from sim.rendering.view import FAR_M, DepthImage, View

SUN_LEVEL = 2000.0
_SUN_SURELY = 1000.0  # no other light is so bright
_DISC_LEVELS = (150.0, 600.0)  # of the disc, as clouds all but hide it and in a clear sky
_VEIL: Ladder = (0.0, 7.0, 16.0, 28.0, 44.0, 64.0)
_ASTRAY: Ladder = (0.0, 0.12, 0.22, 0.32, 0.42, 0.5)  # share of the light by the sun that goes elsewhere
_STRAY: Ladder = (0.0, 0.35, 0.7, 1.2, 1.8, 2.6)
# Along the line from the sun (1) through the middle (0): place, radius in image widths, level, ring or disc.
_GHOSTS = (
    (0.62, 0.018, 16.0, False),
    (0.34, 0.035, 9.0, True),
    (-0.22, 0.012, 20.0, False),
    (-0.46, 0.055, 8.0, True),
    (-0.72, 0.028, 14.0, False),
    (-1.08, 0.085, 7.0, True),
    (-1.45, 0.04, 9.0, False),
)
_EDGE_PX = 25.0  # from the border, where the flare begins to go
_SHRUNK = 2


def mark_sun(light: Floats, view: View, depth_m: DepthImage, toward_sun: Array) -> None:
    """Raise the sun's disc to ``SUN_LEVEL`` wherever the sky shows, in place."""
    sun_cam = view.world_from_cam.rotation.T @ toward_sun
    if sun_cam[2] < 0.05:
        return
    (fx, fy), (cx, cy) = view.pinhole.focal_px, view.pinhole.center_px
    u, v = fx * sun_cam[0] / sun_cam[2] + cx, fy * sun_cam[1] / sun_cam[2] + cy
    reach = int(3 * np.radians(SUN_RADIUS_DEG) * max(fx, fy) / sun_cam[2] ** 2) + 2
    height, width = light.shape
    rows = slice(max(0, int(v) - reach), max(0, min(height, int(v) + reach + 1)))
    columns = slice(max(0, int(u) - reach), max(0, min(width, int(u) + reach + 1)))
    if rows.start >= rows.stop or columns.start >= columns.stop:
        return
    y, x = np.mgrid[rows, columns]
    rays = np.stack([(x - cx) / fx, (y - cy) / fy, np.ones_like(x, float)], -1)
    cosine = (rays @ sun_cam) / np.linalg.norm(rays, axis=-1)
    off_deg = np.degrees(np.arccos(np.clip(cosine, -1, 1)))
    per_px_deg = np.degrees(sun_cam[2] / max(fx, fy))
    disc = np.clip((SUN_RADIUS_DEG - off_deg) / per_px_deg + 0.5, 0, 1)
    disc = disc * (depth_m[rows, columns] > FAR_M * 0.999)
    patch = light[rows, columns]
    patch += (disc * (SUN_LEVEL - patch)).astype(np.float32)


class Flare:
    """What one weather's lenses do with the sun."""

    def __init__(self, severity: float, sun: float) -> None:
        """``sun`` is the share of a clear day's direct light."""
        self._veil, self._stray = sun * on_ladder(severity, _VEIL), sun * on_ladder(severity, _STRAY)
        self._astray = sun * on_ladder(severity, _ASTRAY)
        self._brightest = np.float32(np.interp(min(1.0, 3.0 * sun), (0.0, 1.0), _DISC_LEVELS))

    def over(self, light: Floats, camera: Camera) -> Floats:
        """Return the (H, W) light with what the sun in it spills."""
        found = find_sun(light, camera)
        if found is None:
            return light
        (u, v), share = found
        height, width = light.shape
        y, x = np.mgrid[0:height:_SHRUNK, 0:width:_SHRUNK].astype(np.float32)
        along, up = (x - np.float32(u)) / np.float32(width), (y - np.float32(v)) / np.float32(width)
        distance = np.sqrt(along * along + up * up)
        veil = 0.45 + 1.3 * np.exp(-distance / 0.22) + 4.0 * np.exp(-distance / 0.035)
        angle = np.arctan2(up, along)
        star = np.abs(np.cos(3 * angle + 0.4)) ** 60 * np.exp(-distance / 0.11)
        spill = np.float32(self._veil) * veil + np.float32(30 * self._stray) * star
        for place, radius, level, is_ring in _GHOSTS:
            at = [camera.center_px[k] + place * ((u, v)[k] - camera.center_px[k]) for k in (0, 1)]
            out = np.hypot(x - np.float32(at[0]), y - np.float32(at[1])) / np.float32(radius * width)
            shape = np.clip((1.0 - out) * 8, 0, 1)
            if is_ring:
                shape = shape * (0.3 + 0.7 * np.clip(out, 0, 1) ** 4)
            spill += np.float32(self._stray * level) * shape
        spill = cv2.resize(spill * np.float32(share), (width, height), interpolation=cv2.INTER_LINEAR)
        lost = np.float32(self._astray * share) * np.exp(-distance / np.float32(0.3))
        left = 1 - cv2.resize(lost, (width, height), interpolation=cv2.INTER_LINEAR)
        return np.asarray(np.clip(light, 0, self._brightest) * left + spill)


def find_sun(light: Floats, camera: Camera) -> tuple[tuple[float, float], float] | None:
    """Return the sun's pixel and the share of its disc that is seen; None if it is hidden or outside."""
    height, width = light.shape
    rows, columns = np.nonzero(light > _SUN_SURELY)
    if not len(rows):
        return None
    weight = (light[rows, columns] - _SUN_SURELY) / (SUN_LEVEL - _SUN_SURELY)
    u, v = float(np.average(columns, weights=weight)), float(np.average(rows, weights=weight))
    area_px = np.pi * (np.radians(SUN_RADIUS_DEG) * float(np.mean(camera.focal_px))) ** 2
    from_border = min(u, v, width - 1 - u, height - 1 - v)
    inside = float(np.clip((from_border + 2) / _EDGE_PX, 0, 1))
    return (u, v), min(1.0, float(weight.sum()) / (0.7 * area_px)) * inside


def with_halos(light: Floats, strength: float) -> Floats:
    """Return the (H, W) light with halos around what is far brighter than the rest; every lens makes some."""
    height, width = light.shape
    small = cv2.resize(light, (-(-width // 4), -(-height // 4)), interpolation=cv2.INTER_AREA)
    excess = np.clip(small - np.float32(25.0), 0, _DISC_LEVELS[1])
    halo = 0.05 * cv2.GaussianBlur(excess, (0, 0), 2.0) + 0.05 * cv2.GaussianBlur(excess, (0, 0), 9.0)
    return np.asarray(light + np.float32(strength) * cv2.resize(halo, (width, height)))
