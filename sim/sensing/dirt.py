"""Dirt on the lens: specks and smears that stay where they are, take light away and veil the rest.

Dirt is far out of focus, so everything has soft edges. It darkens where it covers, and glows with what falls
on it from all of the view: bright dust by day, dark mud in front of the sky.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from sim.sensing.face import GreyImage

_SPECKS_PER_SEVERITY, _SMEARS_PER_SEVERITY = 22, 1.6
_SPECK_RADIUS, _MEDIAN_RADIUS, _RADIUS_SPREAD = (0.004, 0.06), 0.011, 0.75  # of the image's width; log-normal
_SMEAR_LENGTH, _SMEAR_WIDTH = (0.15, 0.5), (0.015, 0.05)
_FILM = 0.045  # cover of the whole lens, per severity
_RAGGED = 0.35  # how far edges stray, in radii
_OUT_OF_FOCUS_PX = 1.5
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
    film = _FILM * severity * (0.65 + 0.35 * _noise(size_px, 9, rng))
    ragged = np.asarray(_RAGGED * (_noise(size_px, 26, rng) + 0.5 * _noise(size_px, 70, rng)), np.float32)
    depth = np.zeros(size_px[::-1], np.float32)  # optical, of specks and smears
    scattered = np.zeros_like(depth)
    shapes = [_speck] * round(_SEVERITIES * _SPECKS_PER_SEVERITY)
    shapes += [_smear] * round(_SEVERITIES * _SMEARS_PER_SEVERITY)
    for shape in shapes:
        own = rng.spawn(1)[0]  # so that no shape depends on those before it
        turn, density, brightness = own.uniform(0, 1), own.uniform(0.5, 3.0), own.uniform(0.25, 0.95)
        thickness = max(severity / _SEVERITIES - turn, 0.0) ** 0.5
        if thickness > 0:
            added = shape(size_px, ragged, own) * np.float32(density * (0.4 + 0.6 * thickness))
            depth += added
            scattered += np.float32(brightness) * added
    depth, scattered = (
        np.asarray(cv2.GaussianBlur(each, (0, 0), _OUT_OF_FOCUS_PX)) for each in (depth, scattered)
    )
    cover = np.minimum(1 - np.exp(-depth) * (1 - film), _MOST_COVER)
    # The film is bright dust; where nothing else lies it alone scatters.
    brightness_map = (scattered + 0.9 * film) / (depth + film)
    return Dirt(cover.astype(np.float32), (cover * brightness_map).astype(np.float32))


def _speck(size_px: tuple[int, int], ragged: GreyImage, rng: np.random.Generator) -> GreyImage:
    along, across = _grid(size_px, rng)
    radius = np.clip(_MEDIAN_RADIUS * np.exp(_RADIUS_SPREAD * rng.standard_normal()), *_SPECK_RADIUS)
    stretch = rng.uniform(1.0, 1.6)
    return _soft_edge(np.hypot(along / stretch, across) / np.float32(radius) + ragged)


def _smear(size_px: tuple[int, int], ragged: GreyImage, rng: np.random.Generator) -> GreyImage:
    along, across = _grid(size_px, rng)
    length, width = rng.uniform(*_SMEAR_LENGTH), rng.uniform(*_SMEAR_WIDTH)
    bend, streaks, phase_rad = rng.uniform(-0.6, 0.6), rng.uniform(2, 5) / width, rng.uniform(0, 2 * np.pi)
    across = across - np.float32(bend) * along * along / np.float32(length)
    streaky = 0.6 + 0.4 * np.cos(np.float32(streaks) * across + np.float32(phase_rad))
    return np.asarray(0.6 * streaky * _soft_edge(np.hypot(along / length, across / width) + ragged))


def _grid(size_px: tuple[int, int], rng: np.random.Generator) -> tuple[GreyImage, GreyImage]:
    """Return (H, W) right and down from a random middle, in image widths, turned by a random angle."""
    width, height = size_px
    middle = rng.uniform(0, 1, 2) * (1, height / width)
    angle_rad = rng.uniform(0, np.pi)
    right = np.arange(width, dtype=np.float32) / width - np.float32(middle[0])
    down = (np.arange(height, dtype=np.float32) / width - np.float32(middle[1]))[:, None]
    cos, sin = np.float32(np.cos(angle_rad)), np.float32(np.sin(angle_rad))
    return np.asarray(cos * right + sin * down), np.asarray(cos * down - sin * right)


def _soft_edge(distance: GreyImage) -> GreyImage:
    """Fall from 1 well inside distance one to 0 well outside."""
    share = np.clip((1.5 - distance) / 1.1, 0, 1)
    return np.asarray(share * share * (3 - 2 * share), np.float32)


def _noise(size_px: tuple[int, int], across: int, rng: np.random.Generator) -> GreyImage:
    """Return (H, W) smooth noise between about -1 and 1, ``across`` lumps wide."""
    coarse = rng.uniform(-1, 1, (round(across * size_px[1] / size_px[0]) + 1, across)).astype(np.float32)
    return np.asarray(cv2.resize(coarse, size_px, interpolation=cv2.INTER_CUBIC))
