"""Small patches of images, upright or as another camera would see them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import cv2
import numpy as np
import numpy.typing as npt

from estimator.bundle import Image
from estimator.observations import Index
from estimator.se3 import Array
from estimator.warps import Warps

Patches = npt.NDArray[np.float32]
_ROWS_AT_ONCE = 1000


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
        moved = grid if warps is None else warps[rows].apply(grid)
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


def normalised(patches: Patches) -> tuple[Patches, Patches]:
    """Return (N, P*P) patches of zero mean and unit norm, and their (N,) norms before that."""
    flat = patches.reshape(len(patches), -1)
    flat = flat - flat.mean(1, keepdims=True)
    norm = np.sqrt(np.square(flat).sum(1))
    return flat / np.maximum(norm, 1e-6)[:, None], norm
