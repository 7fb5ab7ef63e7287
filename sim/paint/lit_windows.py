"""What of a house front shines at night: some windows and most shops, through what hangs or stands there."""

from __future__ import annotations

import cv2
import numpy as np
import numpy.typing as npt

from sim.paint.canvas import RgbImage
from sim.shapes.facade import Facade, Panel

_LIT = {"window": 0.3, "display": 0.7}  # share of them
_LEVEL = {"window": (2.5, 12.0), "display": (5.0, 16.0)}  # of a sunny day's levels
_FRAME_M, _BAR_M = 0.07, 0.03


def light_windows(
    facade: Facade, image: RgbImage, texel_m: float, rng: np.random.Generator
) -> npt.NDArray[np.uint8]:
    """Return (H, W) the level of the light that each texel of a painted house sheds at night."""
    glow = np.zeros(image.shape[:2], np.uint8)
    for panel in facade.all_panels:
        if panel.kind in _LIT and rng.random() < _LIT[panel.kind]:
            _light(glow, image, panel, facade, texel_m, float(rng.uniform(*_LEVEL[panel.kind])))
    return glow


def _light(
    glow: npt.NDArray[np.uint8],
    image: RgbImage,
    panel: Panel,
    facade: Facade,
    texel_m: float,
    level: float,
) -> None:
    """Light one pane: bright cloth and goods more than the dark of the room, frames and bars not at all."""
    top = facade.height_m - panel.z1
    rows = _texels(top + _FRAME_M, facade.height_m - panel.z0 - _FRAME_M, texel_m)
    columns = _texels(panel.x0 + _FRAME_M, panel.x1 - _FRAME_M, texel_m)
    grey = cv2.cvtColor(np.ascontiguousarray(image[rows, columns]), cv2.COLOR_RGB2GRAY)
    pane = level * (0.45 + 0.55 * grey.astype(np.float32) / 255)
    if panel.kind == "window":
        middle = (panel.x1 - panel.x0) / 2 - _FRAME_M
        pane[:, _texels(middle - _BAR_M, middle + _BAR_M, texel_m)] = 0
        for k in range(1, facade.muntins + 1):
            y = (panel.z1 - panel.z0) * k / (facade.muntins + 1) - _FRAME_M
            pane[_texels(y - _BAR_M, y + _BAR_M, texel_m)] = 0
    glow[rows, columns] = pane.astype(np.uint8)


def _texels(low_m: float, high_m: float, texel_m: float) -> slice:
    return slice(max(0, round(low_m / texel_m)), max(0, round(high_m / texel_m)))
