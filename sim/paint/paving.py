"""Paving that is set piece by piece: setts of gutters and bays, slabs of pavements, kerb stones."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from estimator.se3 import Array
from sim.paint.canvas import Canvas, RgbImage
from sim.paint.noise import crooked_line, fractal

JOINT = 0.7  # tone of a joint relative to the stones


def lay_setts(
    canvas: Canvas,
    x0: float,
    y0: float,
    x1: float,
    y1: float,
    stone_m: tuple[float, float],
    tone: float,
    rng: np.random.Generator,
) -> None:
    """Rows of stones over a rectangle, every stone its own tone, with dark joints, each row shifted."""
    height, width = canvas.shape
    left, right = (int(np.clip(round(x / canvas.texel_m[0]), 0, width)) for x in (x0, x1))
    top, bottom = (int(np.clip(round(y / canvas.texel_m[1]), 0, height)) for y in (y0, y1))
    if left >= right or top >= bottom:
        return
    x = (np.arange(left, right) + 0.5) * canvas.texel_m[0]
    joint_m = min(0.02, 0.14 * stone_m[1])
    edges_y = np.linspace(top, bottom, max(1, round((y1 - y0) / stone_m[1])) + 1).round().astype(int)
    for low, high in pairwise(edges_y):
        if high <= low:
            continue
        count = int((x1 - x0) / stone_m[0] / 0.8) + 3
        edges = x0 - rng.uniform(0, stone_m[0]) + np.cumsum(stone_m[0] * rng.uniform(0.8, 1.25, count))
        stone = np.searchsorted(edges, x)
        shade = tone * rng.uniform(0.87, 1.13, count + 1)[:, None] * np.array([1.02, 1.0, 0.96])
        row = shade[stone]
        inside = np.concatenate([[x0], edges])[stone]
        row[x - inside < max(joint_m, 0.8 * canvas.texel_m[0])] = tone * JOINT
        canvas.pixels[low:high, left:right] = row
        canvas.pixels[low : low + max(1, round(joint_m / canvas.texel_m[1])), left:right] = tone * JOINT


def pavement(
    length_m: float,
    width_m: float,
    texel_m: tuple[float, float],
    rng: np.random.Generator,
    wear: float = 1.0,
) -> Canvas:
    """A strip of pavement: kerb stones along the lower edge, slabs or setts, repairs, stains, covers.

    Args:
        length_m: Along the street.
        width_m: Across.
        texel_m: Texel sizes.
        rng: Source of randomness.
        wear: 1 for an old pavement full of repairs and spots, 0 for a plain new one.
    """
    canvas = Canvas(length_m, width_m, texel_m, (140, 137, 130))
    # The ground behind the facade line is seen in front gardens and gaps only: trodden earth and gravel.
    kind = rng.choice(["slabs", "slabs", "setts"])
    tone = rng.uniform(104, 138)
    stone = (rng.uniform(0.4, 0.6), rng.uniform(0.35, 0.5)) if kind == "slabs" else (0.2, 0.2)
    lay_setts(canvas, 0, 0, length_m, width_m, stone, tone, rng)
    for _ in range(round(wear * length_m * width_m / 12)):
        x, y = rng.uniform(0, length_m), rng.uniform(0, width_m)
        w, h = rng.uniform(0.5, 2.5), rng.uniform(0.4, 1.4)
        shade = rng.uniform(62, 150)
        canvas.rect(x, y, x + w, y + h, (shade, shade, shade), 0.9)
        canvas.frame(x, y, x + w, y + h, 0.04, (50, 50, 50), 0.8)
    for _ in range(round(wear * length_m * width_m / 1.4)):
        radius = min(0.03 + 0.03 * rng.pareto(2.0), 0.4)
        shade = rng.choice([45.0, 60.0, 195.0])
        at = (rng.uniform(0, length_m), rng.uniform(0, width_m))
        canvas.ellipse(at, (radius * rng.uniform(0.7, 1.4), radius), (shade, shade, shade), 0.5)
    for _ in range(round(wear * length_m / 4)):
        start = np.array([rng.uniform(0, length_m), rng.uniform(0, width_m)])
        canvas.stroke(
            crooked_line(rng, start, rng.uniform(0, 3.1), rng.uniform(0.5, 2.0), 0.5), 0.03, (50, 48, 45), 0.8
        )
    lay_setts(canvas, 0, width_m - 0.28, length_m, width_m, (0.9, 0.28), 165, rng)
    canvas.shade(0.07 * fractal(rng, canvas.shape, canvas.cells(2.0), 4, 0.6))
    return canvas


def verge(length_m: float, width_m: float, texel_m: tuple[float, float], rng: np.random.Generator) -> Canvas:
    """A verge, seen with the road below: crushed stone beside the road, then grass with bare patches."""
    canvas = Canvas(length_m, width_m, texel_m, (96, 104, 62))
    canvas.shade(0.16 * fractal(rng, canvas.shape, canvas.cells(1.6), 5, 0.8))
    bare = fractal(rng, canvas.shape, canvas.cells(2.4), 5, 0.7)
    edge = np.linspace(width_m, 0.0, canvas.shape[0])[:, None]  # metres from the road
    stony = np.clip(1.6 - edge + 0.3 * bare, 0.0, 1.0)
    stones = 118.0 * (1.0 + 0.14 * fractal(rng, canvas.shape, canvas.cells(0.25), 3, 0.9))
    canvas.pixels += stony[..., None] * (stones[..., None] * np.array([1.0, 0.98, 0.94]) - canvas.pixels)
    worn = np.clip(bare - 1.0, 0.0, 1.0)
    canvas.pixels += worn[..., None] * (np.array([128.0, 112.0, 84.0], np.float32) - canvas.pixels)
    return canvas


def grassland(tile_m: float, rng: np.random.Generator) -> RgbImage:
    """A square of grass, earth and gravel that continues itself at its edges."""
    canvas = Canvas(tile_m, tile_m, (0.06, 0.06), (92, 98, 62))
    tufts, mud = (
        _seamless(rng, canvas, size, octaves, gain) for size, octaves, gain in ((0.5, 4, 0.9), (3.0, 6, 0.8))
    )
    canvas.shade(0.2 * tufts)
    canvas.pixels += (mud > 0.6)[..., None] * np.array([38, 12, 18], np.float32)
    return canvas.image()


def _seamless(rng: np.random.Generator, canvas: Canvas, size_m: float, octaves: int, gain: float) -> Array:
    """Noise whose opposite edges fit: two fields, each hidden where its own edges are."""
    one, other = (fractal(rng, canvas.shape, canvas.cells(size_m), octaves, gain) for _ in range(2))
    rows, columns = canvas.shape
    hidden = np.minimum(
        np.abs(np.linspace(-1, 1, rows))[:, None] ** 8 + np.abs(np.linspace(-1, 1, columns)) ** 8, 1.0
    )
    shifted = np.roll(other, (rows // 2, columns // 2), axis=(0, 1))
    blend: Array = (1 - hidden) * one + hidden * shifted
    return np.asarray(blend / np.sqrt((1 - hidden) ** 2 + hidden**2))
