"""Sealed cracks: narrow, jagged, unevenly worn."""

from __future__ import annotations

import numpy as np

from sim.paint.canvas import Canvas
from sim.paint.road import _seal

TEXEL_M = 0.01


def test_a_seal_is_a_ragged_strip_of_a_few_centimetres() -> None:
    canvas = Canvas(4.0, 1.0, (TEXEL_M, TEXEL_M), (100, 100, 100))
    line = np.column_stack([np.arange(0.5, 3.5, 0.15), np.full(20, 0.5)])
    _seal(canvas, line, np.random.default_rng(0))
    darker = 100 - canvas.pixels[:, 60:330, 0]
    breadth_m = TEXEL_M * (darker > 15).sum(axis=0)
    assert 0.03 < np.median(breadth_m) < 0.07
    middles_m = TEXEL_M * (darker * np.arange(100)[:, None]).sum(axis=0) / darker.sum(axis=0)
    assert middles_m.std() > 0.004, "a straight band has no ragged edge"
    assert darker.max(axis=0).std() > 5, "it is worn unevenly"
