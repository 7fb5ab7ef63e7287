"""Find the landmarks of one camera in the images of the others, at the same time and later.

This is what ties the rig together: cameras that share view at once, and the front and rear group, which
share none, through what one saw and the other sees a moment later.
"""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from estimator.ahead import is_ahead
from estimator.align import AlignConfig, align
from estimator.anchor_view import ViewLimits, view_anchors
from estimator.anchors import Anchors
from estimator.bundle import Image
from estimator.config import Config
from estimator.observations import Index, Observations
from estimator.patches import sample_patches
from estimator.ranges import HalfPatchPx, LengthM, Share, SigmaPx, SizeOrNonePx, StepCount
from estimator.scene import Scene
from estimator.se3 import Array


class HandoverConfig(Config):
    """How many sightings are sought, and how sure a match must be."""

    views_per_camera: StepCount = 4
    border_px: SizeOrNonePx = 8.0
    max_distance_m: LengthM = 40.0
    half_px: HalfPatchPx = 7
    min_peak: Share = 0.75
    max_rival: Share = 0.9
    sigma_px: SigmaPx = 0.25
    view: ViewLimits = ViewLimits(min_stretch=0.33, max_norm=5.0)
    align: AlignConfig = AlignConfig(half_px=7, min_likeness=0.82)


def hand_over(
    scene: Scene,
    images: Sequence[Sequence[Image | None]],
    observations: Observations,
    anchors: Anchors,
    radius_px: Array,
    config: HandoverConfig,
) -> Observations:
    """Return new sightings of known landmarks by cameras other than the one that tracked them.

    Args:
        scene: Poses, cameras and landmarks.
        images: ``images[keyframe][camera]``.
        observations: The sightings there are.
        anchors: Patch and plane of every landmark.
        radius_px: (C,) how far from the prediction to search, by searched camera.
        config: Limits.
    """
    landmark, camera, keyframe, predicted = _candidates(scene, images, anchors, config)
    radius = radius_px[camera]
    start = _search(scene, images, anchors, (landmark, camera, keyframe), predicted, radius, config)
    found = np.isfinite(start).all(1)
    landmark, camera, keyframe, start = landmark[found], camera[found], keyframe[found], start[found]
    aligned = align(scene, images, anchors, landmark, camera, keyframe, start, config.align)
    good = np.isfinite(aligned.pixels).all(1)
    count = int(good.sum())
    return Observations(
        landmark[good],
        camera[good],
        keyframe[good],
        aligned.pixels[good],
        np.full(count, config.sigma_px),
        np.ones(count, bool),
    )


def _candidates(
    scene: Scene, images: Sequence[Sequence[Image | None]], anchors: Anchors, config: HandoverConfig
) -> tuple[Index, Index, Index, Array]:
    """List where landmarks should appear in other cameras, the views most like the anchor's first."""
    known = np.flatnonzero(anchors.valid & np.isfinite(scene.points_world[:, 0]))
    rows = []
    for camera, mounted in enumerate(scene.rig.cameras.values()):
        other = known[anchors.camera[known] != camera]
        options = []
        for keyframe in range(len(scene.world_from_egos)):
            if images[keyframe][camera] is None:
                continue
            pose = scene.camera_pose(camera, keyframe)
            points_cam = pose.inverse().apply(scene.points_world[other])
            pixels = mounted.camera.project(points_cam)
            distance = np.linalg.norm(points_cam, axis=1)
            inside = mounted.camera.contains(pixels, config.border_px) & (distance < config.max_distance_m)
            inside &= is_ahead(points_cam, distance)
            anchor_distance = _anchor_distance(scene, anchors, other)
            unlike = np.abs(np.log(np.maximum(distance, 1e-6) / anchor_distance))
            chosen = np.flatnonzero(inside)
            options.append(
                np.column_stack(
                    [other[chosen], np.full(len(chosen), keyframe), pixels[chosen], unlike[chosen]]
                )
            )
        if options:
            best = _best_views(np.vstack(options), config.views_per_camera)
            rows.append(np.column_stack([best[:, 0], np.full(len(best), camera), best[:, 1:4]]))
    table = np.vstack(rows) if rows else np.zeros((0, 5))
    return (
        table[:, 0].astype(np.int64),
        table[:, 1].astype(np.int64),
        table[:, 2].astype(np.int64),
        table[:, 3:5],
    )


def _anchor_distance(scene: Scene, anchors: Anchors, landmark: Index) -> Array:
    _, center = scene.pose_arrays(anchors.camera[landmark], anchors.keyframe[landmark])
    return np.asarray(np.linalg.norm(scene.points_world[landmark] - center, axis=1))


def _best_views(options: Array, count: int) -> Array:
    """Keep the ``count`` rows of each landmark (column 0) that differ least in distance (last column)."""
    order = np.lexsort((options[:, -1], options[:, 0]))
    options = options[order]
    _, start, size = np.unique(options[:, 0], return_index=True, return_counts=True)
    rank = np.arange(len(options)) - np.repeat(start, size)
    return options[rank < count]


def _search(
    scene: Scene,
    images: Sequence[Sequence[Image | None]],
    anchors: Anchors,
    where: tuple[Index, Index, Index],
    predicted_px: Array,
    radius_px: Array,
    config: HandoverConfig,
) -> Array:
    """Return (N, 2) the best place of each warped patch within its radius; NaN if unclear."""
    landmark, camera, keyframe = where
    view = view_anchors(scene, anchors, landmark, camera, keyframe, predicted_px, config.view)
    result = np.full((len(landmark), 2), np.nan)
    whole = np.ceil(radius_px).astype(int)
    for radius in np.unique(whole[view.visible]):
        rows = np.flatnonzero(view.visible & (whole == radius))
        template = view.patches(images, rows, config.half_px)
        field = sample_patches(
            images, keyframe[rows], camera[rows], predicted_px[rows], None, config.half_px + int(radius)
        )
        for row, patch, area in zip(rows, template, field, strict=True):
            shift = _peak(patch, area, int(radius), config)
            if shift is not None:
                result[row] = predicted_px[row] + shift
    return result


def _peak(patch: Array, area: Array, radius: int, config: HandoverConfig) -> Array | None:
    """Return the (2,) shift of the correlation peak if it is high and has no rival elsewhere."""
    score = cv2.matchTemplate(area, patch, cv2.TM_CCOEFF_NORMED)
    _, peak, _, at = cv2.minMaxLoc(score)
    if not peak > config.min_peak:
        return None
    rivals = score.copy()
    cv2.circle(rivals, at, 4, -1.0, -1)
    if rivals.max() > config.max_rival * peak:
        return None
    return np.array([at[0] - radius, at[1] - radius], float)
