"""Small patches of images, and how the view of a plane changes them from one camera to another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import cv2
import numpy as np
import numpy.typing as npt

from estimator.bundle import Image
from estimator.observations import Index
from estimator.scene import Scene
from estimator.se3 import Array

Patches = npt.NDArray[np.float32]
_STEP_PX = 3.0
_ROWS_AT_ONCE = 1000


def sample_patches(
    images: Sequence[Sequence[Image | None]],
    keyframe: Index,
    camera: Index,
    centers_px: Array,
    affine: Array | None,
    half_px: int,
) -> Patches:
    """Cut (N, P, P) patches, P = 2 half + 1, warped by (N, 2, 2) linear maps (None: upright).

    ``images[keyframe][camera]`` must exist for every row. Beyond the border the edge is repeated.
    """
    side = 2 * half_px + 1
    offset = np.arange(-half_px, half_px + 1, dtype=np.float32)
    grid = np.stack(np.meshgrid(offset, offset), -1).reshape(-1, 2)
    out = np.empty((len(centers_px), side, side), np.float32)
    centers = centers_px.astype(np.float32)
    maps = None if affine is None else affine.astype(np.float32).transpose(0, 2, 1)
    for rows, image in _by_image(images, keyframe, camera):
        moved = grid if maps is None else grid @ maps[rows]
        where = (centers[rows, None] + moved).reshape(-1, side, 2)
        patch = cv2.remap(image, where, None, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        out[rows] = patch.reshape(-1, side, side)
    return out


def _by_image(
    images: Sequence[Sequence[Image | None]], keyframe: Index, camera: Index
) -> Iterator[tuple[Index, Image]]:
    """Yield the rows that read each image, a thousand at a time: OpenCV's remap takes no taller map."""
    cameras = len(images[0])
    group = keyframe * cameras + camera
    order = np.argsort(group, kind="stable")
    edges = np.flatnonzero(np.diff(group[order])) + 1
    for rows in np.split(order, edges) if len(order) else ():
        image = images[int(keyframe[rows[0]])][int(camera[rows[0]])]
        assert image is not None, "a sighting without an image"
        for chunk in np.array_split(rows, -(-len(rows) // _ROWS_AT_ONCE)):
            yield chunk, image


def plane_warp(
    scene: Scene,
    anchor: tuple[Index, Index],
    target: tuple[Index, Index],
    points_world: Array,
    normals_world: Array,
    target_px: Array,
) -> Array:
    """Return the (N, 2, 2) linear maps from target offsets to anchor offsets, in pixels.

    The neighbourhood of each point is taken as the plane through it; the homography that the plane induces
    is linearised by central differences through both lenses, so any camera model serves.

    Args:
        scene: Poses and cameras.
        anchor: (N,) cameras and (N,) keyframes the patches come from.
        target: (N,) cameras and (N,) keyframes they are looked for in.
        points_world: (N, 3) points on the planes.
        normals_world: (N, 3) unit normals.
        target_px: (N, 2) where the points appear in the target.

    Returns:
        The maps; NaN where the plane is seen edge-on or from behind a camera.

    Reference:
        Hartley & Zisserman 2004, sec. 13.1.
    """
    rotation_target, center_target = scene.pose_arrays(*target)
    rotation_anchor, center_anchor = scene.pose_arrays(*anchor)
    distance = np.einsum("ni,ni->n", normals_world, points_world - center_target)
    columns = []
    for direction in np.eye(2) * _STEP_PX:
        ends = []
        for sign in (-1.0, 1.0):
            rays_cam = scene.unproject(target[0], target_px + sign * direction)
            rays = np.einsum("nij,nj->ni", rotation_target, rays_cam)
            with np.errstate(divide="ignore", invalid="ignore"):
                reach = distance / np.einsum("ni,ni->n", normals_world, rays)
            reach[~(reach > 0)] = np.nan
            on_plane = center_target + reach[:, None] * rays
            in_anchor = np.einsum("nji,nj->ni", rotation_anchor, on_plane - center_anchor)
            ends.append(scene.project(anchor[0], in_anchor))
        columns.append((ends[1] - ends[0]) / (2 * _STEP_PX))
    return np.stack(columns, -1)


def normalised(patches: Patches) -> tuple[Patches, Patches]:
    """Return (N, P*P) patches of zero mean and unit norm, and their (N,) norms before that."""
    flat = patches.reshape(len(patches), -1)
    flat = flat - flat.mean(1, keepdims=True)
    norm = np.sqrt(np.square(flat).sum(1))
    return flat / np.maximum(norm, 1e-6)[:, None], norm
