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
from sim.light.slopes import slopes_at
from sim.rendering.view import FAR_M, DepthImage, View

Floats = npt.NDArray[np.float32]
STEP = 3  # pixels between samples
_BEND = 3e-4  # of 1/depth between neighbours, 1/m, that makes an edge or a crease; planes have none


@dataclass(frozen=True, eq=False)
class Surfaces:
    """Geometry of one view; what costs is worked out when it is asked for.

    Attributes:
        view: The view.
        depth_m: (H, W) along the optical axis.
    """

    view: View
    depth_m: DepthImage

    @property
    def eye_m(self) -> Floats:
        """(3,) world position of the camera."""
        return self.view.world_from_cam.translation.astype(np.float32)

    @property
    def stretch(self) -> Floats:
        """(H, W) distance along the ray over depth."""
        return _plane(self.view.pinhole)[2]

    @cached_property
    def sky(self) -> npt.NDArray[np.bool_]:
        """(H, W) where nothing is."""
        return np.asarray(self.depth_m > FAR_M * 0.999)

    @property
    def rise(self) -> Floats:
        """(H, W) how much a ray rises for each metre of its depth."""
        x, y, _ = _plane(self.view.pinhole)
        by_x, by_y, ahead = self.view.world_from_cam.rotation[2].astype(np.float32)
        return np.asarray(by_x * x[None, :] + (by_y * y + ahead)[:, None])

    @cached_property
    def points_m(self) -> Floats:
        """(3, h, w) world positions of every third pixel of every third row."""
        x, y, _ = _plane(self.view.pinhole)
        depth = self.depth_m[::STEP, ::STEP]
        points_cam = np.stack([x[::STEP] * depth, y[::STEP, None] * depth, depth])
        return np.asarray(self._turned(points_cam) + self.eye_m[:, None, None])

    @cached_property
    def normals(self) -> Floats:
        """(3, h, w) unit world normals that face the camera."""
        x, y, _ = _plane(self.view.pinhole)
        here = self._nearness[::STEP, ::STEP]
        return self._turned(_normals(here, self._slopes, x[::STEP], y[::STEP, None], self.view.pinhole))

    def enlarged(self, coarse: Floats) -> Floats:
        """Return (H, W) of what is known at (h, w); at edges from the sample on the same plane."""
        height, width = self.depth_m.shape
        shift = np.array([[STEP, 0, 0], [0, STEP, 0]], np.float32)
        full = cv2.warpAffine(
            coarse, shift, (width, height), flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE
        )
        index, low = self._edges
        full.ravel()[index] = coarse.ravel().take(low)
        return np.asarray(full)

    def _turned(self, vectors_cam: Floats) -> Floats:
        turn = self.view.world_from_cam.rotation.astype(np.float32)
        return np.asarray((turn @ vectors_cam.reshape(3, -1)).reshape(vectors_cam.shape))

    @cached_property
    def _nearness(self) -> Floats:
        return np.asarray(1 / self.depth_m, np.float32)

    @cached_property
    def _slopes(self) -> Floats:
        """(2, h, w) how 1/depth grows by a pixel to the right and down: constant on planes."""
        return slopes_at(self._nearness, STEP)

    @cached_property
    def _edges(self) -> tuple[npt.NDArray[np.intp], npt.NDArray[np.int32]]:
        """Flat indices of pixels at edges, and of the sample to take there."""
        return _edge_samples(self._nearness, self._slopes)


@lru_cache(maxsize=128)
def _plane(pinhole: Camera) -> tuple[Floats, Floats, Floats]:
    """Return ray coordinates at depth one by column and by row, and the (H, W) length of those rays."""
    (width, height), (fx, fy), (cx, cy) = pinhole.size_px, pinhole.focal_px, pinhole.center_px
    x = ((np.arange(width) - cx) / fx).astype(np.float32)
    y = ((np.arange(height) - cy) / fy).astype(np.float32)
    return x, y, np.sqrt(1 + x[None, :] ** 2 + y[:, None] ** 2)


def _normals(here: Floats, slopes: Floats, x: Floats, y: Floats, pinhole: Camera) -> Floats:
    """Return (3, h, w) unit normals towards the camera, from (h, w) 1/depth and its slopes.

    With nearness q = 1/z a plane n . p = d is n_x x + n_y y + n_z = d q, linear in the image: the gradient of
    q gives its normal, exactly.
    """
    by_x, by_y = (slopes[k] * np.float32(pinhole.focal_px[k]) for k in (0, 1))
    normal = np.stack([by_x, by_y, here - by_x * x - by_y * y])
    size = np.sqrt(np.einsum("ihw,ihw->hw", normal, normal)) + np.float32(1e-12)
    return np.asarray(normal / -size)


def _edge_samples(nearness: Floats, slopes: Floats) -> tuple[npt.NDArray[np.intp], npt.NDArray[np.int32]]:
    """Return flat indices of pixels at edges, and of the sample around each whose plane it lies on best."""
    width = nearness.shape[1]
    bend = cv2.absdiff(cv2.Laplacian(nearness, cv2.CV_32F, ksize=1), 0)
    edge = cv2.dilate(cv2.compare(bend, _BEND, cv2.CMP_GT), np.ones((2 * STEP - 1,) * 2, np.uint8))
    index = np.flatnonzero(edge)
    rows, columns = slopes.shape[1:]
    row, column = np.divmod(index.astype(np.int32), np.int32(width))
    high_row, right_column = row // STEP, column // STEP
    here, coarse = nearness.ravel().take(index), nearness[::STEP, ::STEP].ravel()
    right, down = slopes.reshape(2, -1)
    best, best_gap = np.zeros_like(row), np.full(len(index), np.inf, np.float32)
    for below in (0, 1):
        low_row = np.minimum(high_row + np.int32(below), np.int32(rows - 1))
        offset_down = (row - STEP * low_row).astype(np.float32)
        for beside in (0, 1):
            low_column = np.minimum(right_column + np.int32(beside), np.int32(columns - 1))
            sample = low_row * np.int32(columns) + low_column
            gap = coarse.take(sample) - here
            gap += right.take(sample) * (column - STEP * low_column).astype(np.float32)
            gap += down.take(sample) * offset_down
            np.abs(gap, out=gap)
            nearer = gap < best_gap
            np.copyto(best, sample, where=nearer)
            np.copyto(best_gap, gap, where=nearer)
    return index, best
