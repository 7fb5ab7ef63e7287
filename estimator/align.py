"""Measure where a landmark's anchor patch appears in other images, to a small part of a pixel.

Tracking from frame to frame adds up small errors; comparing every sighting with one anchor does not.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from estimator.anchor_view import ViewLimits, view_anchors
from estimator.anchors import Anchors
from estimator.bundle import Image
from estimator.config import Config
from estimator.observations import Index
from estimator.patches import Patches, normalised, sample_patches
from estimator.ranges import HalfPatchPx, Share, SizePx, StepCount
from estimator.scene import Scene
from estimator.se3 import Array


class AlignConfig(Config):
    """Patch size, steps, and the likeness below which an alignment is not believed."""

    half_px: HalfPatchPx = 6
    steps: StepCount = 8
    settled_px: Share = 0.005
    min_likeness: Share = 0.8
    max_shift_px: SizePx = 3.0
    view: ViewLimits = ViewLimits()


@dataclass(frozen=True, eq=False)
class Aligned:
    """N alignments.

    Attributes:
        pixels: (N, 2) where the anchor's centre appears; NaN where it could not be aligned.
        likeness: (N,) correlation of patch and image there, -1 to 1; NaN where not aligned.
        sigma_px: (N,) standard deviation of a coordinate, were what patch and image differ by plain noise.
    """

    pixels: Array
    likeness: Array
    sigma_px: Array


def align(
    scene: Scene,
    images: Sequence[Sequence[Image | None]],
    anchors: Anchors,
    landmark: Index,
    camera: Index,
    keyframe: Index,
    start_px: Array,
    config: AlignConfig,
) -> Aligned:
    """Shift each landmark's warped anchor patch until it matches the image.

    Inverse compositional Gauss-Newton on a shift, blind to brightness and contrast.

    Args:
        scene: Poses, cameras and landmarks that give the warps.
        images: ``images[keyframe][camera]``.
        anchors: Patch and plane of every landmark.
        landmark: (N,) which landmark to look for.
        camera: (N,) in which camera.
        keyframe: (N,) at which keyframe.
        start_px: (N, 2) where to begin.
        config: Limits.

    Returns:
        Pixels and likeness; NaN where the patch cannot be seen, ran away or does not match.

    Reference:
        Baker & Matthews 2004, sec. 3.2.
    """
    pixels = np.full((len(landmark), 2), np.nan)
    likeness = np.full(len(landmark), np.nan)
    sigma_px = np.full(len(landmark), np.nan)
    view = view_anchors(scene, anchors, landmark, camera, keyframe, start_px, config.view)
    rows = np.flatnonzero(view.visible)
    if len(rows) == 0:
        return Aligned(pixels, likeness, sigma_px)
    template = view.patches(images, rows, config.half_px + 1)
    solver, reference, variance_px2 = _prepare(template)
    at = start_px[rows].copy()
    moving = np.arange(len(rows))
    for _ in range(config.steps):
        where = rows[moving]
        seen = sample_patches(images, keyframe[where], camera[where], at[moving], None, config.half_px)
        error = normalised(seen)[0] - reference[moving]
        step = np.clip((solver[moving] @ error[..., None])[..., 0], -1.0, 1.0)
        at[moving] -= step
        moving = moving[np.abs(step).max(1) > config.settled_px]
        if len(moving) == 0:
            break
    seen = sample_patches(images, keyframe[rows], camera[rows], at, None, config.half_px)
    alike = (normalised(seen)[0] * reference).sum(1)
    shift = np.linalg.norm(at - start_px[rows], axis=1)
    good = (alike > config.min_likeness) & (shift < config.max_shift_px)
    pixels[rows[good]] = at[good]
    likeness[rows] = alike
    # Two patches of unit norm differ by 2 - 2 alike; shift, brightness and contrast took four of the values.
    noise2 = 2 * np.maximum(1 - alike, 0) / (reference.shape[1] - 4)
    sigma_px[rows] = np.sqrt(noise2 * variance_px2)
    return Aligned(pixels, likeness, sigma_px)


def _prepare(template: Patches) -> tuple[Patches, Patches, Patches]:
    """Return what each patch has to align with.

    Returns:
        (N, 2, P*P) maps from a difference to a shift, (N, P*P) normalised inner patches, and the (N,) mean
        variances of a coordinate of the shift for differences of unit variance.
    """
    reference, norm = normalised(template[:, 1:-1, 1:-1])
    along_x = 0.5 * (template[:, 1:-1, 2:] - template[:, 1:-1, :-2])
    along_y = 0.5 * (template[:, 2:, 1:-1] - template[:, :-2, 1:-1])
    gradient = np.stack([along_x, along_y], 1).reshape(len(template), 2, -1)
    gradient -= gradient.mean(2, keepdims=True)
    gradient /= np.maximum(norm, 1e-6)[:, None, None]
    # Contrast is free: a change along the patch itself is no shift.
    gradient -= (gradient @ reference[..., None]) * reference[:, None]
    hessian = gradient @ gradient.transpose(0, 2, 1) + np.float32(1e-6) * np.eye(2, dtype=np.float32)
    inverse = np.linalg.inv(hessian)
    return inverse @ gradient, reference, 0.5 * np.trace(inverse, axis1=1, axis2=2)
