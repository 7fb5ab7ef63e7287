"""A wet road: darker, since water lets light into its pores, and a mirror where water stands on it.

``sim.light.mirror`` finds what is mirrored. The reflected scene moves as a mirrored scene does, below the
road, which is what misleads a tracker.
"""

from __future__ import annotations

import numpy as np

from sim.light.surfaces import STEP, Floats, Surfaces
from sim.light.weather import on_ladder
from sim.paint.noise import fractal, smoothstep

_DRY_BELOW, _WET_ABOVE = 0.80, 0.95  # of the normal's z
_TILE_PX, _TILE_M = 512, 48.0
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

    def mirroring(self, wet: Floats, surfaces: Surfaces) -> tuple[Floats, Floats]:
        """Return (h, w) share of light that is mirrored, and how much of that is by standing water.

        Args:
            wet: (h, w) wetness.
            surfaces: The view's geometry.
        """
        rays = surfaces.points_m - surfaces.eye_m[:, None, None]
        slope: Floats = np.abs(rays[2]) / np.sqrt(np.einsum("ihw,ihw->hw", rays, rays))
        fresnel = _AT_RIGHT_ANGLES + (1 - _AT_RIGHT_ANGLES) * (1 - slope) ** 5
        standing = self._standing(surfaces.points_m)
        film = np.float32(self._film) * (1 - standing)
        strength = np.asarray(wet * (standing + film) * fresnel)
        return strength, np.asarray(standing / (standing + film + np.float32(1e-6)))

    def _standing(self, points: Floats) -> Floats:
        """Return how much water stands, by world position; the tile is mirrored at its borders."""
        x, y = (np.abs((points[axis] / np.float32(_TILE_M)) % 2 - 1) * (_TILE_PX - 1) for axis in (0, 1))
        return np.asarray(self._puddles[y.astype(np.intp), x.astype(np.intp)])
