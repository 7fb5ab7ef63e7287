"""Small patches of images, and how the view of a plane changes them from one camera to another."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from estimator.bundle import Image
from estimator.observations import Index, Mask
from estimator.scene import Scene
from estimator.se3 import Array

Patches = npt.NDArray[np.float32]
_STEP_PX = 3.0
_ROWS_AT_ONCE = 1000


@dataclass(frozen=True, eq=False)
class Warps:
    """N maps of offsets from a centre, x to ``linear @ x / (1 + perspective @ x)``, in pixels.

    The perspective part matters: across a patch of a wall seen at a slant the scale changes by several
    percent, and without it every such patch is measured off towards the same side.

    Attributes:
        linear: (N, 2, 2).
        perspective: (N, 2) per pixel.
    """

    linear: Array
    perspective: Array

    def __getitem__(self, rows: Index) -> Warps:
        return Warps(self.linear[rows], self.perspective[rows])

    @property
    def finite(self) -> Mask:
        """(N,) whether the map exists."""
        return np.asarray(np.isfinite(self.linear).all((1, 2)) & np.isfinite(self.perspective).all(1))


def sample_patches(
    images: Sequence[Sequence[Image | None]],
    keyframe: Index,
    camera: Index,
    centers_px: Array,
    warps: Warps | None,
    half_px: int,
) -> Patches:
    """Cut (N, P, P) patches, P = 2 half + 1, through maps from their own offsets (None: upright).

    ``images[keyframe][camera]`` must exist for every row. Beyond the border the edge is repeated.
    """
    side = 2 * half_px + 1
    offset = np.arange(-half_px, half_px + 1, dtype=np.float32)
    grid = np.stack(np.meshgrid(offset, offset), -1).reshape(-1, 2)
    out = np.empty((len(centers_px), side, side), np.float32)
    centers = centers_px.astype(np.float32)
    for rows, image in _by_image(images, keyframe, camera):
        moved = grid if warps is None else _moved(grid, warps[rows])
        where = (centers[rows, None] + moved).reshape(-1, side, 2)
        patch = cv2.remap(image, where, None, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        out[rows] = patch.reshape(-1, side, side)
    return out


def _moved(grid: Patches, warps: Warps) -> Patches:
    """Return (N, P*P, 2) the images of (P*P, 2) offsets."""
    linear = grid @ warps.linear.astype(np.float32).transpose(0, 2, 1)
    depth = 1 + grid @ warps.perspective.astype(np.float32)[:, :, None]
    return np.asarray(linear / np.maximum(depth, np.float32(0.1)))


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
) -> Warps:
    """Return the N maps from target offsets to anchor offsets.

    The neighbourhood of each point is taken as the plane through it; the homography that the plane induces
    is found by differences through both lenses, so any camera model serves.

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

    def carry(offset_px: Array) -> Array:
        """Return where pixels of the target, seen on the plane, appear in the anchoring image."""
        rays_cam = scene.unproject(target[0], target_px + offset_px)
        rays = np.einsum("nij,nj->ni", rotation_target, rays_cam)
        with np.errstate(divide="ignore", invalid="ignore"):
            reach = distance / np.einsum("ni,ni->n", normals_world, rays)
        reach[~(reach > 0)] = np.nan
        on_plane = center_target + reach[:, None] * rays
        return scene.project(anchor[0], np.einsum("nji,nj->ni", rotation_anchor, on_plane - center_anchor))

    center = carry(np.zeros(2))
    columns, shrink = [], []
    for direction in np.eye(2) * _STEP_PX:
        ahead, behind = carry(direction) - center, carry(-direction) - center
        # For x / (1 + c x) both ways, each end is a / (1 + c) and -a / (1 - c) with c in steps.
        total, across = ahead + behind, ahead - behind
        size = np.maximum(np.einsum("ni,ni->n", across, across), 1e-12)
        per_step = -np.einsum("ni,ni->n", total, across) / size
        columns.append(across * (0.5 * (1 - per_step**2) / _STEP_PX)[:, None])
        shrink.append(per_step / _STEP_PX)
    return Warps(np.stack(columns, -1), np.stack(shrink, -1))


def normalised(patches: Patches) -> tuple[Patches, Patches]:
    """Return (N, P*P) patches of zero mean and unit norm, and their (N,) norms before that."""
    flat = patches.reshape(len(patches), -1)
    flat = flat - flat.mean(1, keepdims=True)
    norm = np.sqrt(np.square(flat).sum(1))
    return flat / np.maximum(norm, 1e-6)[:, None], norm
