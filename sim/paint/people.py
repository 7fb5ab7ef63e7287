"""The skin of one person: face, hair, clothes, shoes and bag side by side in one small texture."""

from __future__ import annotations

import numpy as np

from sim.paint.canvas import Canvas, RgbImage
from sim.paint.clothes import paint_arms, paint_bag, paint_legs, paint_torso, pick, wrinkle
from sim.paint.faces import paint_hair, paint_head
from sim.paint.looks import Look
from sim.paint.noise import fractal
from sim.paint.person_layout import REGIONS, SIZE_M, TEXEL_M, fill_region

SKIN_TONES = ((236, 200, 176), (222, 178, 148), (190, 140, 108), (141, 96, 70), (92, 62, 48))
HAIR = ((30, 24, 22), (62, 42, 30), (110, 78, 48), (176, 142, 92), (150, 150, 150), (96, 40, 24))
TOPS = (
    (34, 38, 46), (200, 60, 50), (226, 222, 210), (52, 84, 140), (212, 170, 60), (70, 110, 76),
    (120, 120, 126), (150, 90, 120), (236, 120, 50), (88, 62, 48), (170, 196, 210), (24, 26, 28),
)  # fmt: skip
TROUSERS = ((38, 48, 72), (70, 90, 124), (28, 28, 30), (140, 122, 96), (88, 88, 92), (196, 188, 170))


def paint_person(look: Look, rng: np.random.Generator) -> RgbImage:
    """Paint one person's skin and clothes."""
    skin = np.array(SKIN_TONES[rng.integers(len(SKIN_TONES))], float)
    hair, top = pick(HAIR, rng), pick(TOPS, rng)
    trousers, accent = pick(TROUSERS, rng), pick(TOPS, rng)
    canvas = Canvas(*SIZE_M, (TEXEL_M, TEXEL_M), skin)
    paint_torso(canvas, look, top, trousers, accent)
    paint_legs(canvas, trousers, rng)
    paint_arms(canvas, look, top, accent, skin)
    fill_region(canvas, "coat", top * 0.94)
    x, y, w, h = REGIONS["coat"]
    canvas.rect(x + w / 2 - 0.01, y, x + w / 2 + 0.01, y + h, top * 0.5)
    fill_region(canvas, "hat", accent)
    fill_region(canvas, "bag", pick(TOPS, rng))
    paint_bag(canvas, accent)
    wrinkle(canvas, rng)
    paint_head(canvas, skin, hair)
    paint_hair(canvas, hair, rng)
    canvas.shade(0.025 * fractal(rng, canvas.shape, canvas.cells(0.02), 3, 0.7))
    return canvas.image()
