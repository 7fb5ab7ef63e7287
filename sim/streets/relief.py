"""The shape of the ground as functions of world xy: smooth hills everywhere, bumps and roughness on roads."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array

BUMP_HEIGHT_M = 0.07
BUMP_LENGTH_M = 3.7  # of a hump that is driven over at 30 km/h; Watts 1973
BUMP_FLANK_M = 0.3
_HILL_WAVELENGTHS_M = ((95.0, 125.0), (90.0, 130.0), (150.0, 210.0))  # shorter ones would lift wheels
_HILL_WEIGHTS = (1.0, 0.35, 0.6)  # share of the slope
_LANDSCAPES = 100  # that a road is laid through before one is chosen
_ENOUGH_DOWN = 0.7  # of the steepest slope: the other way need not be steeper
_WISH_TO_TURN = 1.5  # of climb and fall, against crossfall
_ROUGH_WAVES = 40
_ROUGH_WAVELENGTHS_M = (1.2, 12.0)
_CLASS_A_PSD_M3 = (
    16e-6  # displacement spectral density at 0.1 cycles a metre; each class has four times the last
)
_REFERENCE_CPM = 0.1


@dataclass(frozen=True, eq=False)
class Waves:
    """A sum of A (cos(p) - cos(k x + p)): zero at the origin; with p = 0 level there too.

    Attributes:
        k_radpm: (N, 2) wave vectors.
        amplitude_m: (N,).
        phase_rad: (N,).
    """

    k_radpm: Array
    amplitude_m: Array
    phase_rad: Array

    def height_m(self, xy_m: Array) -> Array:
        angles = np.asarray(xy_m, float) @ self.k_radpm.T + self.phase_rad
        return np.asarray((np.cos(self.phase_rad) - np.cos(angles)) @ self.amplitude_m)

    def gradient(self, xy_m: Array) -> Array:
        """(..., 2) slope along x and y."""
        angles = np.asarray(xy_m, float) @ self.k_radpm.T + self.phase_rad
        return np.asarray((np.sin(angles) * self.amplitude_m) @ self.k_radpm)


@dataclass(frozen=True)
class Bump:
    """A hump across a straight piece of road: cosine along it, as wide as the carriageway but the gutters.

    Attributes:
        center_m: World xy.
        yaw_rad: Heading of the road.
        half_width_m: Half its extent across.
    """

    center_m: tuple[float, float]
    yaw_rad: float
    half_width_m: float

    def height_m(self, xy_m: Array) -> Array:
        away = np.asarray(xy_m, float) - self.center_m
        c, s = np.cos(self.yaw_rad), np.sin(self.yaw_rad)
        along, across = away[..., 0] * c + away[..., 1] * s, away[..., 1] * c - away[..., 0] * s
        inside = np.clip(2 * np.abs(along) / BUMP_LENGTH_M, 0, 1)
        flank = np.clip((self.half_width_m - np.abs(across)) / BUMP_FLANK_M, 0, 1)
        return np.asarray(BUMP_HEIGHT_M * (0.5 + 0.5 * np.cos(np.pi * inside)) * flank)


@dataclass(frozen=True, eq=False)
class Relief:
    """Height of the ground in metres at any world xy.

    ``height_m`` is the terrain: zero and level at the origin, gentle everywhere. Everything stands on it.
    ``road_height_m`` adds speed bumps and roughness: the carriageway as it is drawn and as wheels feel it.
    """

    hills: Waves
    rough: Waves
    bumps: tuple[Bump, ...] = ()

    def height_m(self, xy_m: Array) -> Array:
        """Terrain at (..., 2) points; the result is (...)."""
        return self.hills.height_m(xy_m)

    def gradient(self, xy_m: Array) -> Array:
        """Slope of the terrain along world x and y at (..., 2) points; the result is (..., 2)."""
        return self.hills.gradient(xy_m)

    def road_height_m(self, xy_m: Array) -> Array:
        """Carriageway at (..., 2) points; the result is (...)."""
        height = self.hills.height_m(xy_m)
        if self.is_rough:
            height = height + self.rough.height_m(xy_m)
        for bump in self.bumps:
            height = height + bump.height_m(xy_m)
        return np.asarray(height)

    @property
    def is_flat(self) -> bool:
        """Whether the whole world lies at z = 0."""
        return not self.hills.amplitude_m.any() and not self.is_rough and not self.bumps

    @property
    def is_rough(self) -> bool:
        return bool(self.rough.amplitude_m.any())


def draw_hills(slope_percent: float, along_m: Array, rng: np.random.Generator) -> Waves:
    """Draw hills whose steepest slope along a polyline is exactly ``slope_percent``.

    Roads are built up and down a hill rather than across it: of many landscapes the one is taken in which
    the line tilts least sideways, and both climbs and falls.

    Args:
        slope_percent: Rise over run, times 100.
        along_m: (N, 2) the driven line; too short a line can only see the foot of a hill.
        rng: Decides where the hills are; the slope only scales them.
    """
    steps = np.diff(along_m, axis=0)
    ahead = steps / np.maximum(np.linalg.norm(steps, axis=1, keepdims=True), 1e-9)
    landscapes = [_unit_hills(rng) for _ in range(_LANDSCAPES)]
    slopes = [_slopes(hills, along_m[:-1], ahead) for hills in landscapes]
    best = min(range(_LANDSCAPES), key=lambda k: _awkwardness(*slopes[k]))
    scale = slope_percent / 100.0 / float(np.abs(slopes[best][0]).max())
    hills = landscapes[best]
    return Waves(hills.k_radpm, hills.amplitude_m * scale, hills.phase_rad)


def _unit_hills(rng: np.random.Generator) -> Waves:
    lengths_m = np.array([rng.uniform(*span) for span in _HILL_WAVELENGTHS_M])
    # The main wave runs along the line's start, the others anyhow.
    headings = np.array([rng.uniform(-0.5, 0.5), rng.uniform(-1.6, 1.6), rng.uniform(-1.6, 1.6)])
    k = 2 * np.pi / lengths_m[:, None] * np.stack([np.cos(headings), np.sin(headings)], axis=1)
    signs = rng.choice([-1.0, 1.0], len(headings))
    return Waves(k, signs * np.array(_HILL_WEIGHTS) * lengths_m / (2 * np.pi), np.zeros(3))


def _slopes(hills: Waves, points_m: Array, ahead: Array) -> tuple[Array, Array]:
    """(N,) slopes along the unit headings ``ahead`` (N, 2), and (N,) to the left of them."""
    gradient = hills.gradient(points_m)
    along = np.sum(gradient * ahead, axis=1)
    return along, gradient[:, 1] * ahead[:, 0] - gradient[:, 0] * ahead[:, 1]


def _awkwardness(along: Array, across: Array) -> float:
    """How badly a road lies: its crossfall, and the lack of a climb or a fall, over its steepest slope."""
    steepest = float(np.abs(along).max())
    other_way = min(max(float(along.max()), 0.0), max(float(-along.min()), 0.0)) / steepest
    return float(np.abs(across).max()) / steepest - _WISH_TO_TURN * min(other_way, _ENOUGH_DOWN)


def draw_roughness(level: float, rng: np.random.Generator) -> Waves:
    """Draw road unevenness; levels 1 to 5 are the classes A (new motorway) to E (bad unpaved road).

    Waves shorter than the tyre's footprint smooths over are left out.

    Reference:
        ISO 8608:2016, annex C (displacement PSD, waviness 2).
    """
    shortest, longest = _ROUGH_WAVELENGTHS_M
    edges = np.geomspace(1 / longest, 1 / shortest, _ROUGH_WAVES + 1)  # cycles a metre
    n = np.sqrt(edges[1:] * edges[:-1])
    headings, phases = rng.uniform(0, 2 * np.pi, _ROUGH_WAVES), rng.uniform(0, 2 * np.pi, _ROUGH_WAVES)
    psd = _CLASS_A_PSD_M3 * 4.0 ** (level - 1) * (n / _REFERENCE_CPM) ** -2.0 if level > 0 else 0.0 * n
    k = 2 * np.pi * n[:, None] * np.stack([np.cos(headings), np.sin(headings)], axis=1)
    return Waves(k, np.sqrt(2 * psd * np.diff(edges)), phases)
