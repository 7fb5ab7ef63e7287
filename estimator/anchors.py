"""One patch for each landmark that all its sightings are compared with, and the plane it lies on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from estimator.bundle import Image
from estimator.corridor import road_up
from estimator.observations import Index, Mask, Observations
from estimator.patches import normalised, sample_patches
from estimator.scene import Scene
from estimator.se3 import Array
from estimator.warps import plane_warp

_HALF_PX = 6
_MIN_FACING = 0.15


@dataclass(frozen=True, eq=False)
class Anchors:
    """By landmark (M,): the sighting whose patch stands for it, and its plane.

    Attributes:
        valid: Whether the landmark has an anchor at all.
        camera: Camera index of the anchoring sighting.
        keyframe: Keyframe index of the anchoring sighting.
        pixels: (M, 2) where the patch is centred.
        normals_world: (M, 3) unit normal of the local plane, towards the anchoring camera.
    """

    valid: Mask
    camera: Index
    keyframe: Index
    pixels: Array
    normals_world: Array


def choose_anchors(
    scene: Scene, observations: Observations, images: Sequence[Sequence[Image | None]], on_road: Mask
) -> Anchors:
    """Anchor each landmark at the middle sighting of its own track, and find its plane.

    The candidates are the planes a street is made of: the road, upright walls at four headings, and the
    plane facing the camera; the one wins under which the patch looks most like the first and last sighting.
    A smooth patch of road looks nearly the same under all of them and is measured centimetres off under the
    wrong one, so what lies under the car's path is not asked.

    Args:
        scene: Poses, cameras and landmarks.
        observations: The sightings there are.
        images: ``images[keyframe][camera]``.
        on_road: (M,) landmarks that are known to lie on the road.
    """
    own = observations.select(
        ~observations.handed_over & np.isfinite(scene.points_world[observations.landmark, 0])
    )
    order = np.lexsort((own.keyframe, own.landmark))
    landmark, start, count = np.unique(own.landmark[order], return_index=True, return_counts=True)
    middle, first, last = (own.select(order[start + at]) for at in (count // 2, 0 * count, count - 1))
    points = scene.points_world[landmark]
    score = np.full((len(landmark), 6), -np.inf)
    candidates = _candidate_normals(scene, middle, points)
    for index in range(6):
        normals = candidates[:, index]
        score[:, index] = sum(
            _likeness(scene, images, middle, other, points, normals) for other in (first, last)
        )
    score[:, 5] += 0.01  # facing the camera unless another plane is better
    score[on_road[landmark], 0] += 4.0  # beyond what two correlations can sum to
    best = candidates[np.arange(len(landmark)), score.argmax(1)]
    size = len(scene.points_world)
    valid = np.zeros(size, bool)
    valid[landmark] = np.isfinite(score.max(1))
    anchors = Anchors(
        valid, np.zeros(size, np.int64), np.zeros(size, np.int64), np.zeros((size, 2)), np.zeros((size, 3))
    )
    anchors.camera[landmark], anchors.keyframe[landmark] = middle.camera, middle.keyframe
    anchors.pixels[landmark], anchors.normals_world[landmark] = middle.pixels, best
    return anchors


def _candidate_normals(scene: Scene, middle: Observations, points: Array) -> Array:
    """Return (L, 6, 3): up, four headings relative to the car, and towards the camera."""
    _, center = scene.pose_arrays(middle.camera, middle.keyframe)
    view = center - points
    view /= np.linalg.norm(view, axis=1, keepdims=True)
    rotation = np.stack([p.rotation for p in scene.world_from_egos])[middle.keyframe]
    heading = np.arctan2(rotation[:, 1, 0], rotation[:, 0, 0])
    angle = heading[:, None] + np.deg2rad([0.0, 45.0, 90.0, 135.0])
    walls = np.stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)], -1)
    up = road_up(scene, points)[:, None]
    normals = np.concatenate([up, walls, view[:, None]], 1)
    facing = np.einsum("lki,li->lk", normals, view)
    normals = normals * np.where(facing < 0, -1.0, 1.0)[..., None]
    normals[np.abs(facing) < _MIN_FACING] = np.nan
    return normals


def _likeness(
    scene: Scene,
    images: Sequence[Sequence[Image | None]],
    middle: Observations,
    other: Observations,
    points: Array,
    normals: Array,
) -> Array:
    """Return (L,) correlation of the anchor patch, warped, with another sighting; -inf where it fails."""
    warps = plane_warp(
        scene,
        (middle.camera, middle.keyframe),
        (other.camera, other.keyframe),
        points,
        normals,
        other.pixels,
    )
    result = np.full(len(points), -np.inf)
    rows = np.flatnonzero(warps.finite)
    if len(rows):
        template = sample_patches(
            images, middle.keyframe[rows], middle.camera[rows], middle.pixels[rows], warps[rows], _HALF_PX
        )
        seen = sample_patches(
            images, other.keyframe[rows], other.camera[rows], other.pixels[rows], None, _HALF_PX
        )
        result[rows] = (normalised(template)[0] * normalised(seen)[0]).sum(1)
    return result
