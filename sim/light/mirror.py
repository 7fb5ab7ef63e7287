"""What a wet road mirrors around one camera: worked out once an image, for all the pictures it is made of.

A picture may be a strip of rows or one face of a wide lens, and does not show what its road mirrors. So
everything that the camera sees is rendered once more, small and with a margin, from where the camera is in
the middle of the exposure. There the ray that leaves each wet surface is followed until it passes behind
something, and shows that. Beyond the margin the scene is taken to continue its border.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from estimator.camera import Camera
from sim.light.surfaces import STEP, Floats
from sim.rendering.view import DepthImage, View

_MARGIN_PX = 16
_STEPS = np.geomspace(0.03, 8.0, 15)  # along the mirrored ray, in lengths of the viewing ray
# How far a reflection is smeared, down and across, in pixels: by standing water, by a film on grains.
_CALM_PX, _GRAINY_PX = (1.0, 0.6), (9.0, 1.4)
_BEHIND = 0.02  # of its depth by which a ray must lie behind something to have met it
_LEAST_WET = 0.01
_UPSIDE_DOWN = np.array([[1], [1], [-1]], np.float32)


@dataclass(frozen=True, eq=False)
class Seen:
    """One small picture of the surroundings before anything is mirrored.

    Attributes:
        view: Where it is seen from.
        light: (h, w) levels.
        depth_m: (h, w).
        wet: (h, w) how wet what it shows is, 0 to 1.
    """

    view: View
    light: Floats
    depth_m: DepthImage
    wet: Floats


@dataclass(frozen=True, eq=False)
class _Reflected:
    """What the wet surfaces of one of these pictures mirror, (h, w) each.

    Attributes:
        calm, grainy: Light off standing water and off a film, in levels.
        beyond: How far behind the surface what is mirrored seems to be, in lengths of the viewing ray.
    """

    calm: Floats
    grainy: Floats
    beyond: Floats


class Mirror:
    """The reflections on wet ground as one camera sees them around one instant."""

    def __init__(self, around: Sequence[Seen]) -> None:
        self._views = [seen.view for seen in around]
        self._reflected = [_reflected(seen, around) for seen in around]

    def light(self, points_m: Floats, eye_m: Floats, calm: Floats) -> Floats:
        """Return the (h, w) light that surfaces mirror towards an eye near the camera.

        Args:
            points_m: (3, h, w) world positions of the surfaces.
            eye_m: (3,) world position.
            calm: (h, w) share of standing water in what mirrors.
        """
        flat_m = points_m.reshape(3, -1)
        beyond = self._read([one.beyond for one in self._reflected], flat_m, calm.shape)
        # The reflection moves as what lies behind the road would, not as the road does.
        behind_m = flat_m + beyond.reshape(-1) * (flat_m - eye_m[:, None])
        grainy = self._read([one.grainy for one in self._reflected], behind_m, calm.shape)
        return grainy + calm * (
            self._read([one.calm for one in self._reflected], behind_m, calm.shape) - grainy
        )

    def _read(self, images: Sequence[Floats], points_m: Floats, shape: tuple[int, ...]) -> Floats:
        index, column, row, _, _ = _places(points_m, self._views)
        value = np.empty(shape, np.float32)
        for k, image in enumerate(images):
            x = np.clip(column, 0, image.shape[1] - 1).reshape(shape)
            y = np.clip(row, 0, image.shape[0] - 1).reshape(shape)
            here = index.reshape(shape) == k
            np.copyto(value, cv2.remap(image, x, y, cv2.INTER_LINEAR), where=here)
        return value


def wider(view: View) -> View:
    """Return the small view, with a margin, in which reflections are found for a view."""
    pinhole = view.pinhole
    width, height = (max(length // STEP, 1) for length in pinhole.size_px)
    margin_px = min(_MARGIN_PX, width, height)
    (fx, fy), (cx, cy) = pinhole.focal_px, pinhole.center_px
    center_px = ((cx + 0.5) / STEP - 0.5 + margin_px, (cy + 0.5) / STEP - 0.5 + margin_px)
    size_px = (width + 2 * margin_px, height + 2 * margin_px)
    return View(Camera("pinhole", size_px, (fx / STEP, fy / STEP), center_px), view.world_from_cam)


def _reflected(seen: Seen, around: Sequence[Seen]) -> _Reflected:
    light, beyond = np.zeros_like(seen.wet), np.zeros_like(seen.wet)
    rows, columns = np.nonzero(seen.wet > _LEAST_WET)
    if len(rows):
        (fx, fy), (cx, cy) = seen.view.pinhole.focal_px, seen.view.pinhole.center_px
        plane = np.stack([(columns - cx) / fx, (rows - cy) / fy, np.ones(len(rows))])
        rays = np.float32(seen.view.world_from_cam.rotation @ (plane * seen.depth_m[rows, columns]))
        start_m = (rays + seen.view.world_from_cam.translation[:, None]).astype(np.float32)
        light[rows, columns], beyond[rows, columns] = _trace(
            start_m, _UPSIDE_DOWN * rays.astype(np.float32), around
        )
    calm, grainy = (_smeared(light, seen.wet, gloss_px) for gloss_px in (_CALM_PX, _GRAINY_PX))
    return _Reflected(calm, grainy, _smeared(beyond, seen.wet, _GRAINY_PX))


def _trace(start_m: Floats, along: Floats, around: Sequence[Seen]) -> tuple[Floats, Floats]:
    """Follow (3, N) mirrored rays through the pictures; return the (N,) light they meet, and how far off.

    A ray that leaves the pictures shows what it saw last, at the border; one that meets nothing, the sky.
    """
    found, share_at = np.empty(start_m.shape[1], np.float32), np.empty(start_m.shape[1], np.float32)
    going = np.arange(start_m.shape[1])
    views = [seen.view for seen in around]
    for share in _STEPS:
        place = (start_m[:, going] + np.float32(share) * along[:, going]).astype(np.float32)
        index, column, row, depth, inside = _places(place, views)
        met = np.zeros(len(going), bool)
        for k, seen in enumerate(around):
            here = np.flatnonzero(index == k)
            limits = np.array(seen.light.shape) - 1
            at = tuple(
                np.clip(np.rint(axis[here]), 0, limit).astype(np.intp)
                for axis, limit in zip((row, column), limits, strict=True)
            )
            found[going[here]] = seen.light[at]
            met[here] = depth[here] - seen.depth_m[at] > _BEHIND * depth[here]
        share_at[going] = share
        going = going[inside & ~met]
    return found, share_at


def _places(
    points_m: Floats, views: Sequence[View]
) -> tuple[npt.NDArray[np.intp], Floats, Floats, Floats, npt.NDArray[np.bool_]]:
    """Return for (3, N) points which view shows each best, column, row and depth in it, and if inside."""
    found = np.stack([_place(points_m, view) for view in views])  # (views, 4, N)
    index = np.argmax(found[:, 3], axis=0)
    column, row, depth, fit = found[index, :, np.arange(points_m.shape[1])].T
    return index, column, row, depth, fit > 0


def _place(points_m: Floats, view: View) -> Floats:
    """Return (4, N) column, row, depth and how well a view shows points: above 0 for those in it."""
    cam_from_world = view.world_from_cam.inverse()
    turn, shift = cam_from_world.rotation.astype(np.float32), cam_from_world.translation.astype(np.float32)
    x, y, z = turn @ points_m + shift[:, None]
    depth = np.maximum(z, np.float32(1e-3))
    (fx, fy), (cx, cy) = view.pinhole.focal_px, view.pinhole.center_px
    column, row = x / depth * np.float32(fx) + np.float32(cx), y / depth * np.float32(fy) + np.float32(cy)
    width, height = view.pinhole.size_px
    inside = (z > 0.05) & (np.abs(column - (width - 1) / 2) < width / 2)
    inside &= np.abs(row - (height - 1) / 2) < height / 2
    off_axis = z / np.sqrt(x * x + y * y + z * z + np.float32(1e-9))
    return np.stack([column, row, z, np.where(inside, 2 + off_axis, off_axis - 2)])


def _smeared(mirrored: Floats, wet: Floats, gloss_px: tuple[float, float]) -> Floats:
    """Smear the reflection over wet pixels only."""
    down, across = gloss_px
    share = cv2.GaussianBlur(wet, (0, 0), sigmaX=across, sigmaY=down)
    smeared = cv2.GaussianBlur(mirrored * wet, (0, 0), sigmaX=across, sigmaY=down)
    return np.asarray(smeared / np.maximum(share, np.float32(1e-3)))
