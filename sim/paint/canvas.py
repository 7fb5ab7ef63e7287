"""A painting surface measured in metres: every texture of the street is painted on one."""

from __future__ import annotations

import math
from collections.abc import Callable

import cv2
import numpy as np
from numpy.typing import ArrayLike, NDArray

from estimator.se3 import Array

Color = ArrayLike  # RGB, 0 to 255
RgbImage = NDArray[np.uint8]
_FRACTION_BITS = 4


class Canvas:
    """An RGB image with x to the right and y down, both in metres.

    Attributes:
        pixels: (H, W, 3) float32, 0 to 255, open to direct work on whole areas.
        texel_m: (x, y) size of a texel.
    """

    def __init__(self, width_m: float, height_m: float, texel_m: tuple[float, float], color: Color) -> None:
        self.texel_m = texel_m
        shape = (max(4, round(height_m / texel_m[1])), max(4, round(width_m / texel_m[0])), 3)
        self.pixels: Array = np.empty(shape, np.float32)
        self.pixels[:] = np.asarray(color, np.float32)

    @property
    def shape(self) -> tuple[int, int]:
        """(height, width) in texels."""
        return self.pixels.shape[0], self.pixels.shape[1]

    def cells(self, size_m: float) -> tuple[float, float]:
        """A length as (vertical, horizontal) texels, as noise wants it."""
        return size_m / self.texel_m[1], size_m / self.texel_m[0]

    def shade(self, field: Array) -> None:
        """Multiply by 1 + field, a (H, W) map."""
        self.pixels *= (1.0 + field)[..., None]

    def fill(self, polygon_m: Array, color: Color, alpha: float = 1.0, worn: Array | None = None) -> None:
        """Paint a polygon.

        Args:
            polygon_m: (N, 2) corners.
            color: Grey or RGB.
            alpha: Opacity.
            worn: (H, W) map of how much paint is left, 0 to 1.
        """
        points = self._to_px(polygon_m)
        self._blend(
            points,
            2,
            color,
            alpha,
            worn,
            lambda mask, p: cv2.fillPoly(mask, [p], 255, cv2.LINE_AA, _FRACTION_BITS),
        )

    def rect(
        self,
        x0: float,
        y0: float,
        x1: float,
        y1: float,
        color: Color,
        alpha: float = 1.0,
        worn: Array | None = None,
    ) -> None:
        """Paint an upright rectangle; texels that it covers in part are mixed in proportion."""
        columns, across = _coverage(x0 / self.texel_m[0], x1 / self.texel_m[0], self.shape[1])
        rows, down = _coverage(y0 / self.texel_m[1], y1 / self.texel_m[1], self.shape[0])
        if len(across) and len(down):
            self._mix((rows, columns), alpha * np.outer(down, across), color, worn)

    def frame(
        self, x0: float, y0: float, x1: float, y1: float, width_m: float, color: Color, alpha: float = 1.0
    ) -> None:
        """Paint the four bars just inside a rectangle."""
        w = width_m
        for bar in ((x0, y0, x1, y0 + w), (x0, y1 - w, x1, y1), (x0, y0, x0 + w, y1), (x1 - w, y0, x1, y1)):
            self.rect(*bar, color=color, alpha=alpha)

    def stroke(
        self, points_m: Array, width_m: float, color: Color, alpha: float = 1.0, closed: bool = False
    ) -> None:
        """Paint a polyline; what is thinner than a texel gets fainter instead."""
        width_px = width_m / float(np.mean(self.texel_m))
        faint = min(1.0, width_px)
        thickness = max(1, round(width_px))
        points = self._to_px(points_m)
        self._blend(
            points,
            thickness + 2,
            color,
            alpha * faint,
            None,
            lambda mask, p: cv2.polylines(mask, [p], closed, 255, thickness, cv2.LINE_AA, _FRACTION_BITS),
        )

    def ellipse(self, center_m: ArrayLike, radii_m: ArrayLike, color: Color, alpha: float = 1.0) -> None:
        """Paint an upright ellipse."""
        angles = np.linspace(0, 2 * np.pi, 28, endpoint=False)
        self.fill(
            np.asarray(center_m) + np.stack([np.cos(angles), np.sin(angles)], 1) * np.asarray(radii_m),
            color,
            alpha,
        )

    def text(
        self, words: str, x_m: float, base_m: float, height_m: float, color: Color, alpha: float = 1.0
    ) -> None:
        """Write capital letters about ``height_m`` tall on the base line."""
        thickness = max(1, round(0.16 * height_m / self.texel_m[1]))
        scale = height_m / self.texel_m[1] / 21.0
        x, base = round(x_m / self.texel_m[0]), round(base_m / self.texel_m[1])
        (width, height), below = cv2.getTextSize(words, cv2.FONT_HERSHEY_SIMPLEX, scale, thickness)
        mask = np.zeros((height + below + 2 * thickness, width + 2 * thickness), np.uint8)
        at = (thickness, height + thickness)
        cv2.putText(mask, words, at, cv2.FONT_HERSHEY_SIMPLEX, scale, 255, thickness, cv2.LINE_AA)
        left, top = x - at[0], base - at[1]
        y0, x0 = max(0, -top), max(0, -left)
        y1, x1 = min(mask.shape[0], self.shape[0] - top), min(mask.shape[1], self.shape[1] - left)
        if y0 < y1 and x0 < x1:
            window = (slice(top + y0, top + y1), slice(left + x0, left + x1))
            self._mix(window, mask[y0:y1, x0:x1] * (alpha / 255.0), color, None)

    def image(self) -> RgbImage:
        """(H, W, 3) uint8."""
        return np.clip(self.pixels, 0, 255).astype(np.uint8)

    def _to_px(self, points_m: Array) -> Array:
        result: Array = np.asarray(points_m, float) / np.asarray(self.texel_m) - 0.5
        return result

    def _blend(
        self,
        points_px: Array,
        margin_px: int,
        color: Color,
        alpha: float,
        worn: Array | None,
        draw: Callable[[Array, Array], object],
    ) -> None:
        height, width = self.shape
        x0, y0 = np.maximum(np.floor(points_px.min(axis=0)).astype(int) - margin_px, 0)
        x1, y1 = np.minimum(np.ceil(points_px.max(axis=0)).astype(int) + margin_px + 1, [width, height])
        if x0 >= x1 or y0 >= y1:
            return
        mask = np.zeros((y1 - y0, x1 - x0), np.uint8)
        fixed = np.round((points_px - [x0, y0]) * 2**_FRACTION_BITS).astype(np.int32)
        draw(mask, fixed)
        self._mix((slice(y0, y1), slice(x0, x1)), mask * (alpha / 255.0), color, worn)

    def _mix(self, window: tuple[slice, slice], weight: Array, color: Color, worn: Array | None) -> None:
        if worn is not None:
            weight = weight * worn[window]
        area = self.pixels[window]
        area += weight.astype(np.float32)[..., None] * (np.asarray(color, np.float32) - area)


def _coverage(low: float, high: float, limit: int) -> tuple[slice, Array]:
    """Which of ``limit`` texels an interval touches, and how much of each it covers."""
    first, last = max(0, math.floor(low)), min(limit, math.ceil(high))
    if first >= last:
        return slice(0, 0), np.empty(0)
    index = np.arange(first, last)
    return slice(first, last), np.minimum(high, index + 1) - np.maximum(low, index)
