"""A wet road: darker, since water lets light into its pores, and a mirror where water stands on it.

Reflections are traced through the picture itself: the ray that leaves a wet surface is followed until it
passes behind something the camera sees, and shows that. Outside, the picture is taken to continue its
border. The reflected scene moves as a mirrored scene does, below the road, which is what misleads a tracker.
"""

from __future__ import annotations

import cv2
import numpy as np
import numpy.typing as npt

from sim.light.surfaces import STEP, Floats, Surfaces
from sim.light.weather import on_ladder
from sim.paint.noise import fractal, smoothstep
from sim.rendering.view import View

_DRY_BELOW, _WET_ABOVE = 0.80, 0.95  # of the normal's z
_TILE_PX, _TILE_M = 512, 48.0
_STEPS = np.geomspace(0.03, 8.0, 15)  # along the mirrored ray, in lengths of the viewing ray
# How far a reflection is smeared, down and across, in coarse samples: by standing water, by a film on grains.
_CALM_PX, _GRAINY_PX = (1.0, 0.6), (9.0, 1.4)
_BEHIND = 0.02  # of its depth by which a ray must lie behind something to have met it
_AT_RIGHT_ANGLES = 0.02  # of light that water reflects


class WetRoad:
    """The water on up-facing surfaces of one world; the same puddles for every camera and instant."""

    def __init__(self, rain: float, rng: np.random.Generator) -> None:
        self._darkening = 1.0 - on_ladder(rain, (1.0, 0.80, 0.70, 0.62, 0.56, 0.52))
        self._film = on_ladder(rain, (0.0, 0.12, 0.22, 0.32, 0.42, 0.5))
        puddles = on_ladder(rain, (0.0, 0.25, 0.45, 0.65, 0.85, 1.0))
        tile = fractal(rng, (_TILE_PX, _TILE_PX), (48.0, 48.0), 5, 0.55)
        # Mirrored at its borders, so that it tiles the world without a seam.
        self._puddles = (puddles * smoothstep(0.55, 1.15, tile)).astype(np.float32)

    def wetness(self, surfaces: Surfaces, exposed: Floats) -> Floats:
        """Return (h, w) how wet each sample is, 0 to 1; ``exposed`` is the share that rain reaches."""
        wet = np.clip((surfaces.normals[2] - _DRY_BELOW) / np.float32(_WET_ABOVE - _DRY_BELOW), 0, 1)
        wet[surfaces.sky[::STEP, ::STEP]] = 0
        return np.asarray(wet * exposed)

    def darkened(self, wet: Floats) -> Floats:
        """Return (h, w) what is left of the albedo."""
        return np.asarray(1 - np.float32(self._darkening) * wet)

    def mirror(self, light: Floats, wet: Floats, surfaces: Surfaces, view: View) -> tuple[Floats, Floats]:
        """Return (h, w) strength of the reflection and the light that is reflected.

        Args:
            light: (H, W) the picture so far.
            wet: (h, w) wetness.
            surfaces: The view's geometry.
            view: The view.
        """
        rows, columns = np.nonzero(wet > 0.01)
        strength, mirrored = np.zeros_like(wet), np.zeros_like(wet)
        if not len(rows):
            return strength, mirrored
        points = surfaces.points_m[:, rows, columns]
        rays = points - surfaces.eye_m[:, None]
        length = np.sqrt(np.einsum("ij,ij->j", rays, rays))
        slope = np.abs(rays[2]) / length
        fresnel = _AT_RIGHT_ANGLES + (1 - _AT_RIGHT_ANGLES) * (1 - slope) ** 5
        standing = self._standing(points)
        film = np.float32(self._film) * (1 - standing)
        strength[rows, columns] = wet[rows, columns] * (standing + film) * fresnel
        calm = np.zeros_like(wet)
        calm[rows, columns] = standing / (standing + film + np.float32(1e-6))
        bounced = rays * np.array([[1], [1], [-1]], np.float32)
        small = cv2.resize(light, wet.shape[::-1], interpolation=cv2.INTER_AREA)
        mirrored[rows, columns] = _trace(points, bounced, small, surfaces, view)
        grainy = _smeared(mirrored, wet, _GRAINY_PX)
        return strength, grainy + calm * (_smeared(mirrored, wet, _CALM_PX) - grainy)

    def _standing(self, points: Floats) -> Floats:
        """Return how much water stands, by world position; the tile is mirrored at its borders."""
        x, y = (np.abs((points[axis] / np.float32(_TILE_M)) % 2 - 1) * (_TILE_PX - 1) for axis in (0, 1))
        return np.asarray(self._puddles[y.astype(np.intp), x.astype(np.intp)])


def _trace(points: Floats, bounced: Floats, small: Floats, surfaces: Surfaces, view: View) -> Floats:
    """Follow (3, N) mirrored rays through the picture; return the (N,) light that they meet.

    A ray that leaves the picture shows what it saw last, at the border; one that meets nothing, the sky.
    """
    cam_from_world = view.world_from_cam.inverse()
    turn, shift = cam_from_world.rotation.astype(np.float32), cam_from_world.translation.astype(np.float32)
    start, along = turn @ points + shift[:, None], turn @ bounced
    depth = surfaces.depth_m[::STEP, ::STEP]
    found = np.empty(points.shape[1], np.float32)
    going = np.arange(points.shape[1])
    for share in _STEPS:
        place = start[:, going] + np.float32(share) * along[:, going]
        row, column, inside = _pixel(place, view, depth.shape)
        found[going] = small[row, column]
        met = place[2] - depth[row, column] > _BEHIND * place[2]
        going = going[inside & ~met]
    return found


def _pixel(
    points_cam: Floats, view: View, shape: tuple[int, ...]
) -> tuple[npt.NDArray[np.intp], npt.NDArray[np.intp], npt.NDArray[np.bool_]]:
    """Return the coarse rows and columns of points, and which of them lie in the picture."""
    depth = np.maximum(points_cam[2], np.float32(1e-3))
    (fx, fy), (cx, cy) = view.pinhole.focal_px, view.pinhole.center_px
    column = np.rint((points_cam[0] / depth * fx + cx) / STEP)
    row = np.rint((points_cam[1] / depth * fy + cy) / STEP)
    inside = (points_cam[2] > 0.05) & (row >= 0) & (row < shape[0]) & (column >= 0) & (column < shape[1])
    clipped_row = np.clip(row, 0, shape[0] - 1).astype(np.intp)
    return clipped_row, np.clip(column, 0, shape[1] - 1).astype(np.intp), inside


def _smeared(mirrored: Floats, wet: Floats, gloss_px: tuple[float, float]) -> Floats:
    """Smear the reflection over wet samples only."""
    down, across = gloss_px
    share = cv2.GaussianBlur(wet, (0, 0), sigmaX=across, sigmaY=down)
    smeared = cv2.GaussianBlur(mirrored * wet, (0, 0), sigmaX=across, sigmaY=down)
    return np.asarray(smeared / np.maximum(share, np.float32(1e-3)))
