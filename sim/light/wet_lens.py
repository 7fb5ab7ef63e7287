"""Drops on the glass before a lens: each a small strong lens out of focus, that lands, wanders and dries.

A drop belongs to its camera and to nothing in the world. What it does is a function of time alone, so images
may be asked for in any order and at any rate.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import cv2
import numpy as np

from sim.light.surfaces import Floats
from sim.light.weather import on_ladder
from sim.seeds import rng_for

_COUNT = (0.0, 9.0, 20.0, 34.0, 52.0, 74.0)
_SIZE = (0.7, 0.85, 1.0, 1.1, 1.2, 1.3)
_RADIUS = (0.012, 0.055)  # of the image's width
_LIFE_S = (5.0, 16.0)
_LANDING_S = 0.08
_FIELD = 0.30  # of the image's width that a drop shows, upside down, from its middle to its rim
_SHRUNK = 4  # the picture inside a drop is out of focus: a small one will do


@dataclass(frozen=True)
class Drop:
    """One drop from landing to drying; lengths in widths of the image, times since it landed."""

    at: tuple[float, float]
    radius: float
    slide_per_s: float
    wobble: tuple[float, float, float]  # amplitude, rad/s, phase
    lobes: tuple[float, float, float, float]  # strength and phase of two and of three
    glint: float


class WetLens:
    """The drops of one camera."""

    def __init__(self, severity: float, camera: str, seed: int) -> None:
        self._camera, self._seed = camera, seed
        self._size = on_ladder(severity, _SIZE)
        self._count = round(on_ladder(severity, _COUNT))
        rng = rng_for(seed, f"weather.drops.{camera}")
        # Drawn for the worst case, so that more severe means the same drops and more.
        lives_s = rng.uniform(*_LIFE_S, round(_COUNT[5]))
        starts_s = rng.uniform(0, 1, round(_COUNT[5])) * lives_s
        self._places = list(zip(lives_s.tolist(), starts_s.tolist(), strict=True))[: self._count]

    def over(self, light: Floats, time_s: float) -> Floats:
        """Return the (H, W) light behind the drops."""
        height, width = light.shape
        small = cv2.resize(light, (-(-width // _SHRUNK), -(-height // _SHRUNK)), interpolation=cv2.INTER_AREA)
        small = cv2.GaussianBlur(small, (0, 0), 2.5)
        result = light.copy()
        for place, (life_s, start_s) in enumerate(self._places):
            turn, age_s = divmod(time_s + start_s, life_s)
            drop = _drop(self._seed, f"weather.drops.{self._camera}.{place}.{int(turn)}", height / width)
            _refract(result, small, drop, age_s, age_s / life_s, self._size)
        return result


@lru_cache(maxsize=4096)
def _drop(seed: int, purpose: str, aspect: float) -> Drop:
    rng = rng_for(seed, purpose)
    runs = rng.random() < 0.15
    slide = rng.uniform(0.02, 0.06) if runs else rng.uniform(0.0, 0.004)
    small, large = _RADIUS
    return Drop(
        (float(rng.uniform(0, 1)), float(rng.uniform(0, aspect))),
        float(small + (large - small) * rng.random() ** 2),
        float(slide),
        (float(rng.uniform(0, 0.004)), float(rng.uniform(0.3, 1.2)), float(rng.uniform(0, 2 * np.pi))),
        (
            float(rng.uniform(0, 0.14)),
            float(rng.uniform(0, 2 * np.pi)),
            float(rng.uniform(0, 0.09)),
            float(rng.uniform(0, 2 * np.pi)),
        ),
        float(rng.uniform(0.0, 0.3)),
    )


def _refract(result: Floats, small: Floats, drop: Drop, age_s: float, aged: float, size: float) -> None:
    """Lay one drop over the picture, in place."""
    height, width = result.shape
    radius = drop.radius * size * width * _grown(age_s, aged)
    amplitude, rate, phase = drop.wobble
    u = (drop.at[0] + amplitude * np.sin(rate * age_s + phase)) * width
    v = (drop.at[1] + drop.slide_per_s * age_s) * width
    reach = 1.5 * radius
    rows = slice(max(0, int(v - reach)), min(height, int(v + reach) + 2))
    columns = slice(max(0, int(u - reach)), min(width, int(u + reach) + 2))
    if radius < 0.5 or rows.start >= rows.stop or columns.start >= columns.stop:
        return
    y, x = np.mgrid[rows, columns].astype(np.float32)
    x, y = (x - np.float32(u)) / np.float32(radius), (y - np.float32(v)) / np.float32(1.12 * radius)
    angle = np.arctan2(y, x)
    two, two_at, three, three_at = drop.lobes
    outline = 1 + two * np.sin(2 * angle + two_at) + three * np.sin(3 * angle + three_at)
    out = np.sqrt(x * x + y * y) / outline
    field = np.float32(_FIELD * width / _SHRUNK) * np.minimum(out, 1) ** 2
    across = np.float32(u / _SHRUNK) - x * field
    down = np.float32(v / _SHRUNK) - y * field
    seen = cv2.remap(
        small,
        across.astype(np.float32),
        down.astype(np.float32),
        cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_REFLECT,
    )
    seen *= 1 - 0.3 * np.clip((out - 0.4) / 0.6, 0, 1) ** 2  # the rim bends light out of the lens
    seen += drop.glint * seen * np.exp(-((x + 0.3) ** 2 + (y + 0.4) ** 2) / 0.05)
    t = np.clip((1.2 - out) / 0.65, 0, 1)  # out of focus, so without an outline
    cover = (t * t * (3 - 2 * t)).astype(np.float32)
    patch = result[rows, columns]
    patch += cover * (seen - patch)


def _grown(age_s: float, aged: float) -> float:
    """Return the share of its size that a drop has: it spreads on landing, and dries away at its end."""
    landing = min(1.0, age_s / _LANDING_S)
    drying = np.clip((1.0 - aged) / 0.35, 0.0, 1.0)
    return float(landing * (2 - landing) * np.sqrt(drying))
