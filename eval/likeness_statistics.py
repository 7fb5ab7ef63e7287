"""What images of a street look like to a feature tracker, frame by frame, as numbers."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import cv2
import numpy as np
import numpy.typing as npt

from estimator.bundle import Image
from estimator.se3 import Array

SURVIVAL_AFTER = (1, 5, 10)  # frames
_PER_PX = 1e5  # corner counts are told per 100 kpx
_FAST_THRESHOLD = 20
_SLOPE_BAND = (0.02, 0.4)  # cycles a pixel
_SLOPE_RINGS = 19
_BORDER_PX = 5  # a track that comes nearer to the rim is given up
_WORST_RETURN_PX = 0.7  # forward and back again

Statistics = dict[str, Array]


def statistics_of(frames: Sequence[Image]) -> Statistics:
    """Return every statistic's values, one a frame; KLT survival one for every frame with ten more behind it.

    Args:
        frames: (H, W) grey, of one camera in order, more than ten of them.
    """
    gradients = [_gradient(frame) for frame in frames]
    starts = range(len(frames) - max(SURVIVAL_AFTER))
    survivals = np.array([_survival(frames[start : start + max(SURVIVAL_AFTER) + 1]) for start in starts])
    per_px = _PER_PX / frames[0].size
    return {
        "fast20_per_100kpx": np.array([_fast_count(frame) for frame in frames]) * per_px,
        "gftt_per_100kpx": np.array([_good_count(frame) for frame in frames]) * per_px,
        "gradient_mean": np.array([gradient.mean() for gradient in gradients]),
        "textureless_share": np.array([(gradient < 1.0).mean() for gradient in gradients]),
        "contrast_std": np.array([frame.std() for frame in frames]),
        "spectrum_slope": np.array([_spectrum_slope(frame) for frame in frames]),
    } | {f"klt_survival_{after}": survivals[:, after - 1] for after in SURVIVAL_AFTER}


def _fast_count(frame: Image) -> int:
    return len(cv2.FastFeatureDetector.create(_FAST_THRESHOLD).detect(frame))


def _good_count(frame: Image) -> int:
    corners = cv2.goodFeaturesToTrack(frame, 5000, 0.01, 5)
    return 0 if corners is None else len(corners)


def _gradient(frame: Image) -> Array:
    """Return the magnitude in levels a pixel."""
    across, down = (cv2.Sobel(frame, cv2.CV_32F, *order) for order in ((1, 0), (0, 1)))
    return np.asarray(np.hypot(across, down) / 8)


def _spectrum_slope(frame: Image) -> float:
    """Return the slope of log power over log frequency of the top left square; natural images: about -2."""
    side = min(frame.shape)
    patch = frame[:side, :side].astype(float)
    patch = (patch - patch.mean()) * np.outer(np.hanning(side), np.hanning(side))
    power = np.abs(np.fft.fftshift(np.fft.fft2(patch))) ** 2
    rows, columns = np.indices(power.shape) - side // 2
    radius = np.hypot(columns, rows) / side
    edges = np.geomspace(*_SLOPE_BAND, _SLOPE_RINGS + 1)
    rings = [
        (np.log(np.sqrt(low * high)), power[(radius >= low) & (radius < high)])
        for low, high in pairwise(edges)
    ]
    points = np.array([(at, np.log(ring.mean() + 1e-9)) for at, ring in rings if ring.size > 4])
    return float(np.polyfit(points[:, 0], points[:, 1], 1)[0])


def _survival(frames: Sequence[Image]) -> list[float]:
    """Return what share of 200 corners of the first frame is tracked, forward and back, in each later one."""
    points = corners_to_follow(frames[0])
    if not len(points):
        return [0.0] * (len(frames) - 1)
    alive, shares = points, []
    for before, after in pairwise(frames):
        if len(alive):
            moved, kept = follow(before, after, alive)
            alive = moved[kept]
        shares.append(len(alive) / len(points))
    return shares


def corners_to_follow(frame: Image) -> Array:
    """Return the (N, 1, 2) pixels, as float32, of at most 200 corners."""
    points_px = cv2.goodFeaturesToTrack(frame, 200, 0.01, 10)
    return np.zeros((0, 1, 2), np.float32) if points_px is None else np.asarray(points_px)


def follow(before: Image, after: Image, points_px: Array) -> tuple[Array, npt.NDArray[np.bool_]]:
    """Return where (N, 1, 2) points of one frame are in the next, and which (N,) of them are kept."""
    moved_px, found = _flow(before, after, points_px)
    back_px, found_back = _flow(after, before, moved_px)
    returned = np.linalg.norm(back_px - points_px, axis=2).ravel() < _WORST_RETURN_PX
    farthest_px = np.array(after.shape[::-1]) - _BORDER_PX
    inside = ((moved_px[:, 0] > _BORDER_PX) & (moved_px[:, 0] < farthest_px)).all(axis=1)
    return moved_px, np.asarray(found & found_back & returned & inside)


def _flow(before: Image, after: Image, points_px: Array) -> tuple[Array, npt.NDArray[np.bool_]]:
    moved_px, found, _ = cv2.calcOpticalFlowPyrLK(
        before, after, points_px, None, winSize=(15, 15), maxLevel=3
    )
    return np.asarray(moved_px), np.asarray(found).ravel().astype(bool)
