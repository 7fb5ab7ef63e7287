"""What a picture's depth says of the surfaces in it: positions and normals on a coarse grid, and back.

Light from lamps is smooth on a surface and jumps between surfaces. So it is worked out at every third pixel
of every third row, and ``Surfaces.enlarged`` brings it to full resolution without letting it leak over edges.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import cv2
import numpy as np
import numpy.typing as npt

from estimator.camera import Camera
from sim.rendering.view import FAR_M, DepthImage, View

Floats = npt.NDArray[np.float32]
STEP = 3  # pixels between samples
_BEND = 0.04  # of 1/depth between neighbours, relative, that makes an edge; planes have none


@dataclass(frozen=True, eq=False)
class Surfaces:
    """Geometry of one view.

    Attributes:
        depth_m: (H, W) along the optical axis.
        sky: (H, W) where nothing is.
        stretch: (H, W) distance along the ray over depth.
        points_m: (3, h, w) world positions of every third pixel of every third row.
        normals: (3, h, w) unit world normals that face the camera.
        eye_m: (3,) world position of the camera.
    """

    depth_m: DepthImage
    sky: npt.NDArray[np.bool_]
    stretch: Floats
    points_m: Floats
    normals: Floats
    eye_m: Floats

    def enlarged(self, coarse: Floats) -> Floats:
        """Return (H, W) of what is known at (h, w); at edges from the sample nearest in depth."""
        height, width = self.depth_m.shape
        shift = np.array([[STEP, 0, 0], [0, STEP, 0]], np.float32)
        full = cv2.warpAffine(
            coarse, shift, (width, height), flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE
        )
        index, low = self._edges
        full.ravel()[index] = coarse.ravel()[low]
        return np.asarray(full)

    @cached_property
    def _edges(self) -> tuple[npt.NDArray[np.intp], npt.NDArray[np.intp]]:
        """Flat indices of pixels at edges, and of the sample to take there."""
        return _edge_samples(self.depth_m)


def surfaces_of(view: View, depth_m: DepthImage) -> Surfaces:
    """Reconstruct the surfaces of a view from its depth."""
    plane_x, plane_y, stretch = _plane(view.pinhole)
    depth = depth_m[::STEP, ::STEP]
    x, y = plane_x[::STEP] * depth, plane_y[::STEP, None] * depth
    points_cam = np.stack([x, y, depth])
    normals_cam = _normals(points_cam)
    turn = view.world_from_cam.rotation.astype(np.float32)
    eye = view.world_from_cam.translation.astype(np.float32)
    shape = points_cam.shape
    points = (turn @ points_cam.reshape(3, -1)).reshape(shape) + eye[:, None, None]
    normals = (turn @ normals_cam.reshape(3, -1)).reshape(shape)
    return Surfaces(depth_m, depth_m > FAR_M * 0.999, stretch, points, normals, eye)


@lru_cache(maxsize=128)
def _plane(pinhole: Camera) -> tuple[Floats, Floats, Floats]:
    """Return ray coordinates at depth one by column and by row, and the (H, W) length of those rays."""
    (width, height), (fx, fy), (cx, cy) = pinhole.size_px, pinhole.focal_px, pinhole.center_px
    x = ((np.arange(width) - cx) / fx).astype(np.float32)
    y = ((np.arange(height) - cy) / fy).astype(np.float32)
    return x, y, np.sqrt(1 + x[None, :] ** 2 + y[:, None] ** 2)


def _normals(points: Floats) -> Floats:
    """Return (3, h, w) unit normals towards the origin; of two neighbours, the one nearer in depth counts."""
    across, down = _step(points, 2), _step(points, 1)
    normal = np.stack(
        [
            across[1] * down[2] - across[2] * down[1],
            across[2] * down[0] - across[0] * down[2],
            across[0] * down[1] - across[1] * down[0],
        ]
    )
    away = np.einsum("ihw,ihw->hw", normal, points)
    size = np.sqrt(np.einsum("ihw,ihw->hw", normal, normal)) + np.float32(1e-12)
    return np.asarray(normal * (np.where(away > 0, np.float32(-1), np.float32(1)) / size))


def _step(points: Floats, axis: int) -> Floats:
    change = np.diff(points, axis=axis)
    first, last = np.take(change, [0], axis), np.take(change, [-1], axis)
    after, before = np.concatenate([change, last], axis), np.concatenate([first, change], axis)
    return np.where(np.abs(after[2]) < np.abs(before[2]), after, before)


def _edge_samples(depth_m: DepthImage) -> tuple[npt.NDArray[np.intp], npt.NDArray[np.intp]]:
    height, width = depth_m.shape
    nearness = 1 / depth_m
    bend = cv2.absdiff(cv2.Laplacian(nearness, cv2.CV_32F, ksize=1), 0)
    edge = cv2.dilate(cv2.compare(bend, _BEND * nearness, cv2.CMP_GT), np.ones((3, 3), np.uint8))
    index = np.flatnonzero(edge)
    row, column = np.divmod(index.astype(np.int32), np.int32(width))
    row, column = row // STEP, column // STEP
    rows, columns = -(-height // STEP), -(-width // STEP)
    here, coarse = nearness.ravel()[index], nearness[::STEP, ::STEP].ravel()
    best, best_gap = np.zeros_like(row), np.full(len(index), np.inf, np.float32)
    for down in (0, 1):
        for right in (0, 1):
            sample = np.minimum(row + down, rows - 1) * columns + np.minimum(column + right, columns - 1)
            gap = np.abs(coarse[sample] - here)
            nearer = gap < best_gap
            best[nearer], best_gap[nearer] = sample[nearer], gap[nearer]
    return index, best
