"""Falling rain: drops in space, drawn as the streaks they leave while the shutter is open.

The drops stand on a lattice that repeats through the world and falls, so that all cameras see the same drops
and any instant may be asked for in any order. The car drives through them: a streak is the drop's motion
relative to the camera.
"""

from __future__ import annotations

import cv2
import numpy as np

from estimator.se3 import Array
from sim.light.surfaces import Floats
from sim.light.tunnels import TunnelShade
from sim.light.weather import on_ladder
from sim.rendering.view import DepthImage, View

SHUTTER_S = 1 / 100
_BOX_M = 12.0  # the lattice's period; drops are seen within half of it
_NEAR_M, _FAR_M = 0.5, 6.0
_DENSITY = (0.0, 0.7, 1.4, 2.6, 4.2, 6.5)  # drops large enough to be seen, a cubic metre
_WIND_MPS = np.array([0.9, 0.6])
_SUBPIXEL_BITS = 4
_FALLS_IN = 0.3  # share of a drop's sky that must be free
_FAINT = 0.75  # opacity of a streak one pixel wide


class Rain:
    """The drops of one world."""

    def __init__(self, rain: float, rng: np.random.Generator, shelter: TunnelShade | None = None) -> None:
        """``shelter`` says how much of the rain gets to a place; None where nothing is covered."""
        count = round(on_ladder(rain, _DENSITY) * _BOX_M**3)
        self._start_m = rng.uniform(0, _BOX_M, (count, 3))
        self._size_m = rng.uniform(0.0012, 0.0032, count)
        # Larger drops fall faster (Atlas et al. 1973), each with a little of the gusts' own.
        fall = 9.65 - 10.3 * np.exp(-600.0 * self._size_m)
        drift = _WIND_MPS + rng.normal(0, 0.25, (count, 2))
        self._velocity_mps = np.column_stack([drift, -fall])
        self._shelter = shelter

    def add_streaks(
        self,
        light: Floats,
        view: View,
        depth_m: DepthImage,
        velocity_mps: Array,
        time_s: float,
        glow: float,
    ) -> None:
        """Draw the drops over a picture, in place.

        Args:
            light: (H, W) levels.
            view: The view.
            depth_m: (H, W); what is nearer hides drops.
            velocity_mps: (3,) the camera's in the world.
            time_s: Middle of the shutter's opening.
            glow: Level of a drop, which gathers light from nearly the whole scene.
        """
        eye = view.world_from_cam.translation
        offset = (self._start_m + self._velocity_mps * time_s - eye) % _BOX_M
        offset = offset - _BOX_M * (offset > _BOX_M / 2)  # of the copies, the one around the camera
        turn = view.world_from_cam.rotation
        middle = offset @ turn
        seen = (middle[:, 2] > _NEAR_M) & (np.linalg.norm(middle, axis=1) < _FAR_M)
        if self._shelter is not None:
            places = (offset[seen] + eye).T.astype(np.float32)
            seen[seen] = self._shelter.daylight(places[:, None])[0] > _FALLS_IN
        middle, size = middle[seen], self._size_m[seen]
        half = (self._velocity_mps[seen] - velocity_mps) @ turn * (SHUTTER_S / 2)
        first, last = _pixels(middle - half, view), _pixels(middle + half, view)
        shown = _in_picture(first, last, middle, depth_m)
        focal_px = float(np.mean(view.pinhole.focal_px))
        width_px = focal_px * size / middle[:, 2]
        # What is narrower than a pixel covers less of it; the nearest are out of focus.
        faded = np.minimum(1.0, (_FAR_M - np.linalg.norm(middle, axis=1)) / 2.0)
        opacity = _FAINT * np.minimum(width_px, 1.0) * faded * np.minimum(1.0, middle[:, 2] / 1.2)
        cover = np.zeros(light.shape, np.uint8)
        for k in np.flatnonzero(shown):
            ends = np.rint(np.stack([first[k], last[k]]) * 2**_SUBPIXEL_BITS).astype(int)
            thickness = max(1, round(width_px[k]))
            value = round(255 * opacity[k])
            cv2.line(cover, ends[0], ends[1], value, thickness, cv2.LINE_AA, _SUBPIXEL_BITS)
        share = cover * np.float32(1 / 255)
        light += share * (np.float32(glow) - light)


def _pixels(points_cam: Array, view: View) -> Array:
    depth = np.maximum(points_cam[:, 2:], 0.05)
    return np.asarray(points_cam[:, :2] / depth * view.pinhole.focal_px + view.pinhole.center_px)


def _in_picture(first: Array, last: Array, middle: Array, depth_m: DepthImage) -> Array:
    """Tell which streaks lie in the picture, before what is seen there."""
    height, width = depth_m.shape
    at = np.rint((first + last) / 2)
    inside = (np.abs(at - [width / 2, height / 2]) < [width / 2 + 20, height / 2 + 20]).all(axis=1)
    inside &= (np.abs(last - first) < 200).all(axis=1)
    column = np.clip(at[:, 0], 0, width - 1).astype(int)
    row = np.clip(at[:, 1], 0, height - 1).astype(int)
    return np.asarray(inside & (depth_m[row, column] > middle[:, 2]))
