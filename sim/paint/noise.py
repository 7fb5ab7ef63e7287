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
    # Coarse grids are summed at their own resolution and enlarged together, which costs little.
    total = np.zeros((2, 2), np.float32)
    for octave in range(octaves):
        cell_y, cell_x = (max(1.0, cell / 2**octave) for cell in cell_px)
        rows, columns = int(height / cell_y) + 2, int(width / cell_x) + 2
        total = cv2.resize(total, (columns, rows), interpolation=cv2.INTER_LINEAR)
        total += gain**octave * rng.standard_normal((rows, columns), dtype=np.float32)
        if cell_y <= 1.0 and cell_x <= 1.0:
            break
    total = cv2.resize(total, (width, height), interpolation=cv2.INTER_CUBIC)
    result: Array = (total - total.mean()) / max(float(total.std()), 1e-6)
    return result


def grain(rng: np.random.Generator, shape: tuple[int, int]) -> Array:
    """Differences from texel to texel that even out over a few: (H, W) float32 of unit standard deviation.

    Cameras resolve it from close by only; mipmaps leave nothing of it at a distance, as on real asphalt.
    """
    stones = rng.standard_normal(shape, dtype=np.float32)
    stones -= cv2.blur(stones, (3, 3))
    return np.asarray(stones / float(stones.std()))


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


def scrawl(rng: np.random.Generator, length_m: float, height_m: float) -> Array:
    """A looping stroke as of a sprayed tag, from the origin to the right; (N, 2) points in metres."""
    t = np.linspace(0.0, 1.0, 44)
    turns, phases = rng.uniform(2.0, 7.0, (2, 3)), rng.uniform(0, 2 * np.pi, (2, 3))
    sideways, up = np.sin(2 * np.pi * turns[:, :, None] * t + phases[:, :, None]).mean(axis=1)
    result: Array = np.column_stack([length_m * (t + 0.12 * sideways), height_m * up])
    return result
