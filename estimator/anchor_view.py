"""How the anchor patches of landmarks should look in other images, and whether they can be seen there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from pydantic import Field

from estimator.anchors import Anchors
from estimator.bundle import Image
from estimator.config import Config
from estimator.observations import Index, Mask
from estimator.patches import Patches, sample_patches
from estimator.ranges import PositiveShare
from estimator.scene import Scene
from estimator.se3 import Array
from estimator.warps import Warps, plane_warp


class ViewLimits(Config):
    """How far a patch may be stretched, in all and along one direction, and still be compared."""

    min_stretch: PositiveShare = 1 / 3
    max_stretch: float = Field(3.0, ge=1, le=100)
    max_norm: float = Field(6.0, ge=1, le=100)


@dataclass(frozen=True, eq=False)
class AnchorView:
    """N views of landmarks' anchor patches.

    Attributes:
        anchors: The anchors of all landmarks.
        landmark: (N,) whose patch is viewed.
        warps: From offsets in the view to offsets in the anchoring image.
        visible: (N,) whether the patch can be seen and compared there.
    """

    anchors: Anchors
    landmark: Index
    warps: Warps
    visible: Mask

    def patches(self, images: Sequence[Sequence[Image | None]], rows: Index, half_px: int) -> Patches:
        """Return the anchor patches as the views of some rows should show them."""
        landmark = self.landmark[rows]
        keyframe, camera = self.anchors.keyframe[landmark], self.anchors.camera[landmark]
        return sample_patches(
            images, keyframe, camera, self.anchors.pixels[landmark], self.warps[rows], half_px
        )


def view_anchors(
    scene: Scene,
    anchors: Anchors,
    landmark: Index,
    camera: Index,
    keyframe: Index,
    at_px: Array,
    limits: ViewLimits,
) -> AnchorView:
    """Return how (N,) landmarks' patches look at (N, 2) pixels of given cameras and keyframes."""
    source = (anchors.camera[landmark], anchors.keyframe[landmark])
    points_world, normals_world = scene.points_world[landmark], anchors.normals_world[landmark]
    warps = plane_warp(scene, source, (camera, keyframe), points_world, normals_world, at_px)
    with np.errstate(invalid="ignore"):
        stretch = np.sqrt(np.abs(np.linalg.det(warps.linear)))
        visible = warps.finite & anchors.valid[landmark]
        visible &= (stretch > limits.min_stretch) & (stretch < limits.max_stretch)
        visible &= np.linalg.norm(warps.linear, axis=(1, 2)) < limits.max_norm
    return AnchorView(anchors, landmark, warps, visible)
