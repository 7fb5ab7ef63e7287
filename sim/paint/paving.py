"""Paving that is set piece by piece: setts of gutters and bays, slabs of pavements, kerb stones."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from sim.paint.canvas import Canvas
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
    length_m: float, width_m: float, texel_m: tuple[float, float], kerb_first: bool, rng: np.random.Generator
) -> Canvas:
    """A strip of pavement: kerb stones along one edge, slabs or setts, repairs, stains, covers.

    Args:
        length_m: Along the street.
        width_m: Across.
        texel_m: Texel sizes.
        kerb_first: Whether the kerb lies at y = 0 rather than at y = width.
        rng: Source of randomness.
    """
    canvas = Canvas(length_m, width_m, texel_m, (140, 137, 130))
    # The ground behind the facade line is seen in front gardens and gaps only: trodden earth and gravel.
    kind = rng.choice(["slabs", "slabs", "setts"])
    tone = rng.uniform(104, 138)
    stone = (rng.uniform(0.4, 0.6), rng.uniform(0.35, 0.5)) if kind == "slabs" else (0.2, 0.2)
    lay_setts(canvas, 0, 0, length_m, width_m, stone, tone, rng)
    for _ in range(round(length_m * width_m / 12)):
        x, y = rng.uniform(0, length_m), rng.uniform(0, width_m)
        w, h = rng.uniform(0.5, 2.5), rng.uniform(0.4, 1.4)
        shade = rng.uniform(62, 150)
        canvas.rect(x, y, x + w, y + h, (shade, shade, shade), 0.9)
        canvas.frame(x, y, x + w, y + h, 0.04, (50, 50, 50), 0.8)
    for _ in range(round(length_m * width_m / 1.4)):
        radius = min(0.03 + 0.03 * rng.pareto(2.0), 0.4)
        shade = rng.choice([45.0, 60.0, 195.0])
        at = (rng.uniform(0, length_m), rng.uniform(0, width_m))
        canvas.ellipse(at, (radius * rng.uniform(0.7, 1.4), radius), (shade, shade, shade), 0.5)
    for _ in range(round(length_m / 4)):
        start = np.array([rng.uniform(0, length_m), rng.uniform(0, width_m)])
        canvas.stroke(
            crooked_line(rng, start, rng.uniform(0, 3.1), rng.uniform(0.5, 2.0), 0.5), 0.03, (50, 48, 45), 0.8
        )
    kerb = (0.0, 0.28) if kerb_first else (width_m - 0.28, width_m)
    lay_setts(canvas, 0, kerb[0], length_m, kerb[1], (0.9, 0.28), 165, rng)
    canvas.shade(0.07 * fractal(rng, canvas.shape, canvas.cells(2.0), 4, 0.6))
    return canvas
