"""Find new corners to follow, spread over the image by a grid."""

from __future__ import annotations

import cv2
import numpy as np
import numpy.typing as npt
from pydantic import Field

from estimator.bundle import Image
from estimator.config import Config
from estimator.ranges import PositiveCount, Share, StepCount
from estimator.se3 import Array


class DetectConfig(Config):
    """Where corners are taken: one in each free cell, if it is strong enough."""

    cells: PositiveCount = 320
    border_px: int = Field(12, ge=2, le=1000)
    min_eigenvalue: Share = 8e-6
    block_px: int = Field(5, ge=1, le=31)
    bands: StepCount = 6


def detect_corners(
    image: Image,
    occupied_px: Array,
    room: int,
    config: DetectConfig,
    usable: npt.NDArray[np.bool_] | None = None,
) -> Array:
    """Return the strongest corner of every grid cell that holds no point yet.

    If there are more than ``room``, horizontal bands of the image take turns, those with the fewest points
    first: facades would else take every place and leave none for the road, which gives the scale.

    The corner measure is the smaller eigenvalue of the structure tensor at half resolution, which costs a
    tenth of the full one and is as good for a tracker that places its own window.

    Args:
        image: (H, W) grey.
        occupied_px: (N, 2) points that already exist.
        room: How many to return at most.
        config: Grid and threshold.
        usable: (H, W) where corners may be; None: everywhere.

    Returns:
        (M, 2) pixels.

    Reference:
        Shi & Tomasi 1994, sec. 4.
    """
    half = cv2.resize(image, (image.shape[1] // 2, image.shape[0] // 2), interpolation=cv2.INTER_AREA)
    strength = cv2.cornerMinEigenVal(half, config.block_px, ksize=3)
    border = config.border_px // 2
    if usable is not None:
        strength *= usable[: 2 * strength.shape[0] : 2, : 2 * strength.shape[1] : 2]
    cell = max(8, round(np.sqrt(half.size / config.cells)))
    strength[:border], strength[-border:] = 0, 0
    strength[:, :border], strength[:, -border:] = 0, 0
    rows, cols = strength.shape[0] // cell, strength.shape[1] // cell
    tiles = strength[: rows * cell, : cols * cell].reshape(rows, cell, cols, cell).transpose(0, 2, 1, 3)
    tiles = tiles.reshape(rows, cols, cell * cell)
    best = tiles.argmax(-1)
    value = np.take_along_axis(tiles, best[..., None], -1)[..., 0]
    taken = (occupied_px / (2 * cell)).astype(int)
    inside = (taken >= 0).all(1) & (taken[:, 1] < rows) & (taken[:, 0] < cols)
    value[taken[inside, 1], taken[inside, 0]] = 0
    row, col = np.nonzero(value > config.min_eigenvalue)
    band_height = max(1, -(-rows // config.bands))
    held = np.bincount(taken[inside, 1] // band_height, minlength=config.bands)
    chosen = _take_turns(row // band_height, value[row, col], held, room)
    row, col = row[chosen], col[chosen]
    offset_row, offset_col = np.divmod(best[row, col], cell)
    half_px = np.column_stack([col * cell + offset_col, row * cell + offset_row])
    return np.asarray(half_px * 2 + 0.5, float)


def _take_turns(
    band: npt.NDArray[np.int64], value: Array, held: npt.NDArray[np.int64], room: int
) -> npt.NDArray[np.int64]:
    """Return the rows to take: the strongest of each band in turn, counting what the band holds."""
    order = np.lexsort((-value, band))
    _, start, size = np.unique(band[order], return_index=True, return_counts=True)
    rank = np.arange(len(order)) - np.repeat(start, size) + held[band[order]]
    return order[np.argsort(rank, kind="stable")[:room]]
