"""How the view of a plane changes from one camera to another."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from estimator.observations import Index, Mask
from estimator.scene import Scene
from estimator.se3 import Array

Pixels = npt.NDArray[np.float32]
_STEP_PX = 3.0


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

    def apply(self, offsets_px: Pixels) -> Pixels:
        """Return (N, K, 2) the images of (K, 2) offsets, or of (N, K, 2)."""
        linear = offsets_px @ self.linear.astype(np.float32).transpose(0, 2, 1)
        depth = 1 + offsets_px @ self.perspective.astype(np.float32)[:, :, None]
        return np.asarray(linear / np.maximum(depth, np.float32(0.1)))


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
