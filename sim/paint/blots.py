"""Stains: blots without an outline that could be told from another's."""

from __future__ import annotations

import numpy as np

from sim.paint.canvas import Canvas

_CORNERS = 22
_LOBES = np.array([2, 3, 5])
_LOBE_SIZES = (0.3, 0.2, 0.12)  # as a share of the radius
_LAYERS = (1.0, 0.82, 0.6)
_ROUND_UNTIL_M = 0.06  # what is smaller covers too few texels to have a shape


def blot(
    canvas: Canvas,
    at_m: tuple[float, float],
    radii_m: tuple[float, float],
    tone: float,
    rng: np.random.Generator,
) -> None:
    """Spill something: three thin layers, each with lobes of its own and run a little aside.

    Args:
        canvas: What is spilt on.
        at_m: Its middle.
        radii_m: Along x and y.
        tone: Grey level, 0 to 255.
        rng: Source of randomness.
    """
    phases = rng.uniform(0, 2 * np.pi, (len(_LAYERS), len(_LOBES)))
    sizes = rng.normal(0, _LOBE_SIZES, phases.shape)
    run = rng.normal(0, 0.16, (len(_LAYERS), 2)) * radii_m
    if max(radii_m) < _ROUND_UNTIL_M:
        canvas.ellipse(at_m, radii_m, (tone, tone, tone), 0.6)
        return
    angles = np.linspace(0, 2 * np.pi, _CORNERS, endpoint=False)
    around = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    for share, phase, size, aside in zip(_LAYERS, phases, sizes, run, strict=True):
        lobed = 1.0 + np.cos(angles[:, None] * _LOBES + phase) @ size
        outline = around * (share * np.maximum(lobed, 0.25))[:, None] * radii_m
        canvas.fill(outline + at_m + aside, (tone, tone, tone), 0.3)
