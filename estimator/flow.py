"""Follow points from one image to the next, and say which of them to believe."""

from __future__ import annotations

from functools import partial

import cv2
import numpy as np
import numpy.typing as npt
from pydantic import Field

from estimator.bundle import Image
from estimator.config import Config
from estimator.ranges import SizePx
from estimator.se3 import Array


class FlowConfig(Config):
    """Lucas-Kanade settings; the round trip must come back within ``max_return_px``."""

    window_px: int = Field(13, ge=3, le=101)
    levels: int = Field(4, ge=0, le=10)
    max_return_px: SizePx = 0.6


def follow(
    before: Image, after: Image, points_px: Array, guess_px: Array, config: FlowConfig
) -> tuple[Array, npt.NDArray[np.bool_]]:
    """Track (N, 2) points forward and back with pyramidal Lucas-Kanade.

    Args:
        before: (H, W) grey image that the points are in.
        after: (H, W) grey image they are sought in.
        points_px: (N, 2) pixels in ``before``.
        guess_px: (N, 2) where to begin in ``after``.
        config: Window, pyramid and round-trip tolerance.

    Returns:
        The (N, 2) pixels in ``after`` and which of them came back to where they started.

    Reference:
        Bouguet 2001; Kalal et al. 2010 for the round trip.
    """
    if len(points_px) == 0:
        return np.zeros((0, 2)), np.zeros(0, bool)
    start = points_px.astype(np.float32).reshape(-1, 1, 2)
    guess = guess_px.astype(np.float32).reshape(-1, 1, 2)
    lucas_kanade = partial(
        cv2.calcOpticalFlowPyrLK,
        winSize=(config.window_px, config.window_px),
        maxLevel=config.levels,
        criteria=(cv2.TERM_CRITERIA_EPS | cv2.TERM_CRITERIA_COUNT, 30, 0.01),
        flags=cv2.OPTFLOW_USE_INITIAL_FLOW,
        minEigThreshold=1e-4,
    )
    moved, found, _ = lucas_kanade(before, after, start, guess.copy())
    # The way back begins off the right answer by the way that the way there began off it: no free pass.
    back, found_back, _ = lucas_kanade(after, before, moved, start + (moved - guess))
    error_px = np.linalg.norm((back - start).reshape(-1, 2), axis=1)
    height, width = after.shape
    moved = moved.reshape(-1, 2).astype(float)
    inside = (moved > 3).all(1) & (moved[:, 0] < width - 4) & (moved[:, 1] < height - 4)
    good = (found.ravel() > 0) & (found_back.ravel() > 0) & (error_px < config.max_return_px) & inside
    return moved, good
