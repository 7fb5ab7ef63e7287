"""Dirt on the lens: specks and smears that stay where they are, take light away and veil the rest.

Dirt is far out of focus, so everything has soft edges. It darkens where it covers, and glows with what falls
on it from all of the view: bright dust by day, dark mud in front of the sky.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from sim.sensing.face import GreyImage

_SPECKS_PER_SEVERITY, _SMEARS_PER_SEVERITY = 9, 1.4
_SPECK_RADIUS = (0.006, 0.035)  # of the image's width
_SMEAR_LENGTH, _SMEAR_WIDTH = (0.15, 0.5), (0.015, 0.05)
_FILM = 0.035  # cover of the whole lens, per severity
_MOST_COVER = 0.96
_VEIL_SIZE = (8, 5)
_SEVERITIES = 5


@dataclass(frozen=True, eq=False)
class Dirt:
    """What is on one lens.

    Attributes:
        cover: (H, W) share of the light that is taken away.
        glow: (H, W) share of the surrounding light that is scattered in instead.
    """

    cover: GreyImage
    glow: GreyImage

    def over(self, light: GreyImage) -> GreyImage:
        """Return (H, W) light as it is seen through the dirt."""
        around = cv2.resize(light, _VEIL_SIZE, interpolation=cv2.INTER_AREA)
        around = cv2.resize(cv2.GaussianBlur(around, (0, 0), 1.5), light.shape[::-1])
        return np.asarray(light * (1 - self.cover) + around * self.glow)


def splash(size_px: tuple[int, int], severity: float, rng: np.random.Generator) -> Dirt:
    """Soil a lens. A higher severity adds to the same specks and smears, and makes them denser."""
    left = np.zeros(size_px[::-1], np.float32)  # logarithm of the light let through
    scattered = np.zeros_like(left)
    for _ in range(round(_SEVERITIES * _SPECKS_PER_SEVERITY)):
        _add(left, scattered, _speck(size_px, rng), severity / _SEVERITIES, rng)
    for _ in range(round(_SEVERITIES * _SMEARS_PER_SEVERITY)):
        _add(left, scattered, _smear(size_px, rng), severity / _SEVERITIES, rng)
    film = _FILM * severity * _blotches(size_px, rng)
    cover = np.minimum(1 - np.exp(-left) * (1 - film), _MOST_COVER)
    return Dirt(cover.astype(np.float32), (cover * _brightness(left, scattered)).astype(np.float32))


def _add(
    left: GreyImage, scattered: GreyImage, shape: GreyImage, share: float, rng: np.random.Generator
) -> None:
    """Lay a shape on the lens if its turn has come; it thickens from then on."""
    turn, density, brightness = rng.uniform(0, 1), rng.uniform(0.3, 2.2), rng.uniform(0.2, 0.95)
    thickness = max(share - turn, 0.0) ** 0.5
    if thickness > 0:
        depth = np.float32(density * (0.4 + 0.6 * thickness)) * shape
        left += depth
        scattered += np.float32(brightness) * depth


def _brightness(left: GreyImage, scattered: GreyImage) -> GreyImage:
    """Return how much of the surrounding light each place scatters; the film is bright dust."""
    dust, least = 0.9, 0.05
    return np.asarray((scattered + dust * least) / (left + least))


def _grid(size_px: tuple[int, int], rng: np.random.Generator) -> tuple[GreyImage, GreyImage]:
    """Return (H, W) right and down from a random middle, in image widths, turned by a random angle."""
    width, height = size_px
    middle = rng.uniform(0, 1, 2) * (1, height / width)
    angle_rad = rng.uniform(0, np.pi)
    right = np.arange(width, dtype=np.float32) / width - np.float32(middle[0])
    down = (np.arange(height, dtype=np.float32) / width - np.float32(middle[1]))[:, None]
    cos, sin = np.float32(np.cos(angle_rad)), np.float32(np.sin(angle_rad))
    return np.asarray(cos * right + sin * down), np.asarray(cos * down - sin * right)


def _speck(size_px: tuple[int, int], rng: np.random.Generator) -> GreyImage:
    along, across = _grid(size_px, rng)
    radius = np.exp(rng.uniform(*np.log(_SPECK_RADIUS)))
    lobes, phase_rad, depth = rng.integers(2, 6), rng.uniform(0, 2 * np.pi), rng.uniform(0.05, 0.3)
    rim = 1 + depth * np.cos(lobes * np.arctan2(across, along) + phase_rad)
    return _soft_edge(np.hypot(along, across) / (np.float32(radius) * rim))


def _smear(size_px: tuple[int, int], rng: np.random.Generator) -> GreyImage:
    along, across = _grid(size_px, rng)
    length, width = rng.uniform(*_SMEAR_LENGTH), rng.uniform(*_SMEAR_WIDTH)
    bend, streaks, phase_rad = rng.uniform(-0.6, 0.6), rng.uniform(2, 5) / width, rng.uniform(0, 2 * np.pi)
    across = across - np.float32(bend) * along * along / np.float32(length)
    streaky = 0.6 + 0.4 * np.cos(np.float32(streaks) * across + np.float32(phase_rad))
    return np.asarray(0.6 * streaky * _soft_edge(np.hypot(along / length, across / width)))


def _soft_edge(distance: GreyImage) -> GreyImage:
    """Fall from 1 well inside distance one to 0 well outside."""
    share = np.clip((1.35 - distance) / 0.8, 0, 1)
    return np.asarray(share * share * (3 - 2 * share), np.float32)


def _blotches(size_px: tuple[int, int], rng: np.random.Generator) -> GreyImage:
    """Return (H, W) unevenness of a film, 0.3 to 1."""
    coarse = rng.uniform(0.3, 1.0, (6, 9)).astype(np.float32)
    return np.asarray(cv2.resize(coarse, size_px, interpolation=cv2.INTER_CUBIC)).clip(0.3, 1.0)
