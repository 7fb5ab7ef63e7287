"""Which geoms a camera may see: those whose bounding spheres reach into its view."""

from __future__ import annotations

import mujoco
import numpy as np
import numpy.typing as npt

from estimator.camera import Camera
from estimator.se3 import SE3, Array


def in_view(
    model: mujoco.MjModel, data: mujoco.MjData, source: Camera, world_from_cam: SE3
) -> npt.NDArray[np.bool_]:
    """Tell for each geom whether its bounding sphere meets the view of a pinhole; planes always do."""
    centers_cam = world_from_cam.inverse().apply(data.geom_xpos)
    reach_m = model.geom_rbound
    inside = (centers_cam @ side_normals(source).T > -reach_m[:, None]).all(axis=1)
    return np.asarray(inside | (reach_m == 0))


def side_normals(source: Camera) -> Array:
    """Return (4, 3) unit normals of the planes through the image's borders, pointing into the view."""
    width, height = source.size_px
    corners_px = np.array(
        [[-0.5, -0.5], [width - 0.5, -0.5], [width - 0.5, height - 0.5], [-0.5, height - 0.5]]
    )
    corners_cam = source.unproject(corners_px)
    normals = np.cross(corners_cam, np.roll(corners_cam, -1, axis=0))
    return np.asarray(normals / np.linalg.norm(normals, axis=1, keepdims=True))
