"""Fractal noise for textures: structure at every scale between a texel and metres."""

from __future__ import annotations

import cv2
import numpy as np

from estimator.se3 import Array


def fractal(
    rng: np.random.Generator,
    shape: tuple[int, int],
    cell_px: tuple[float, float],
    octaves: int,
    gain: float = 0.6,
) -> Array:
    """Sum of smoothed random grids, each twice as fine and ``gain`` times as strong as the one before.

    Args:
        rng: Source of randomness.
        shape: (height, width) of the result.
        cell_px: (vertical, horizontal) size of the coarsest grain in texels.
        octaves: Number of grids; grids finer than a texel are left out.
        gain: Strength of each grid relative to the coarser one.

    Returns:
        (height, width) float32 with zero mean and unit standard deviation.
    """
    height, width = shape
    total = np.zeros(shape, np.float32)
    for octave in range(octaves):
        cell_y, cell_x = (max(1.0, cell / 2**octave) for cell in cell_px)
        grid = rng.standard_normal((int(height / cell_y) + 4, int(width / cell_x) + 4)).astype(np.float32)
        scaled = cv2.resize(grid, None, fx=cell_x, fy=cell_y, interpolation=cv2.INTER_CUBIC)
        y, x = int(rng.uniform(0, cell_y)), int(rng.uniform(0, cell_x))
        total += gain**octave * scaled[y : y + height, x : x + width]
        if cell_y <= 1.0 and cell_x <= 1.0:
            break
    result: Array = (total - total.mean()) / max(float(total.std()), 1e-6)
    return result


def smoothstep(low: float, high: float, value: Array) -> Array:
    """Blend from 0 at ``low`` to 1 at ``high``."""
    t = np.clip((value - low) / (high - low), 0.0, 1.0)
    result: Array = t * t * (3.0 - 2.0 * t)
    return result


def crooked_line(
    rng: np.random.Generator, start_m: Array, heading_rad: float, length_m: float, wobble: float
) -> Array:
    """A random walk of 15 cm steps: cracks and branches; (N, 2) points in metres."""
    count = max(2, int(length_m / 0.15))
    headings = heading_rad + np.cumsum(rng.normal(0.0, wobble, count))
    headings = heading_rad + (headings - headings[0]) * np.exp(-np.arange(count) / (2.0 * count))
    steps = 0.15 * np.stack([np.cos(headings), np.sin(headings)], axis=1)
    result: Array = np.asarray(start_m) + np.vstack([[0.0, 0.0], np.cumsum(steps, axis=0)])
    return result
