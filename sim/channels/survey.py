"""What all cameras see at one instant, as points and geoms instead of light."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import mujoco
import numpy as np

from estimator.camera import Camera
from estimator.se3 import SE3, Array
from sim.channels.sight_lines import SightLines, sight_lines
from sim.rendering.geom_picture import SKY, GeomImage, GeomRenderer
from sim.rendering.view import View
from sim.sensing.lens import Lens
from sim.vehicle.cameras import world_from_cam

_SAME_POINT = 0.02  # of the distance, and
_SAME_POINT_M = 0.05  # this much: within it two cameras see the same place
_CORNERS = np.array([[0, 0], [1, 0], [0, 1], [1, 1]])


@dataclass(frozen=True, eq=False)
class Sight:
    """What one camera sees; N pixels, row by row.

    Attributes:
        camera: Its lens.
        world_from_cam: Its pose.
        lines: Its viewing rays.
        geom: (N,) index in the model, -1 for the sky.
        range_m: (N,) distance along the ray, infinite for the sky.
    """

    camera: Camera
    world_from_cam: SE3
    lines: SightLines
    geom: GeomImage
    range_m: Array

    def points_cam(self, chosen: Array | slice = slice(None)) -> Array:
        """Return (M, 3) what the chosen pixels show, for the sky a direction."""
        rays = self.lines.rays_cam[chosen]
        reach = np.where(self.geom[chosen] == SKY, 1.0, self.range_m[chosen])
        return np.asarray(rays * reach[:, None])

    def sees(self, points_cam: Array, geoms: GeomImage) -> tuple[Array, Array]:
        """Tell where this camera sees points, which are given in its frame with the geoms they lie on.

        A point is seen if pixels around its projection show its geom, and its distance lies between theirs.

        Returns:
            (M, 2) pixels, NaN outside the image, and (M,) whether nothing hides the point.
        """
        pixels = self.camera.project(points_cam)
        inside = self.camera.contains(pixels)
        pixels[~inside] = np.nan
        ranges_m = np.where(
            self._at_corners(self.geom, pixels) == geoms, self._at_corners(self.range_m, pixels), np.nan
        )
        alike = ~np.isnan(ranges_m).all(0)
        distance_m = np.linalg.norm(points_cam, axis=1)
        room_m = _SAME_POINT_M + _SAME_POINT * distance_m
        nearest_m = np.where(np.isnan(ranges_m), np.inf, ranges_m).min(0)
        farthest_m = np.where(np.isnan(ranges_m), -np.inf, ranges_m).max(0)
        between = (distance_m > nearest_m - room_m) & (distance_m < farthest_m + room_m)
        return pixels, inside & alike & (between | (geoms == SKY))

    def _at_corners(self, values: Array | GeomImage, pixels: Array) -> Array | GeomImage:
        """Return (4, M) values at the four pixels around each place; any for places that are NaN."""
        width, height = self.camera.size_px
        low = np.floor(np.nan_to_num(pixels)).astype(int)
        corners = [np.clip(low + step, 0, [width - 1, height - 1]) for step in _CORNERS]
        return np.stack([values[rows * width + columns] for columns, rows in (at.T for at in corners)])


@dataclass(frozen=True, eq=False)
class Survey:
    """One instant: what every camera sees, and where every geom is.

    Attributes:
        time_s: Since the drive began.
        sights: By camera.
        world_from_geoms: (ngeom, 3, 4) rotation and position.
    """

    time_s: float
    sights: Mapping[str, Sight]
    world_from_geoms: Array


class Surveyor:
    """Surveys one world; keeps each camera's viewing rays."""

    def __init__(self, cameras: Mapping[str, Camera], lenses: Mapping[str, Lens]) -> None:
        """Take the true camera of each lens."""
        self._cameras, self._lenses = cameras, lenses
        self._lines = {name: sight_lines(cameras[name], lens) for name, lens in lenses.items()}

    def survey(self, renderer: GeomRenderer, data: mujoco.MjData, time_s: float) -> Survey:
        """Look through all cameras; positions in ``data`` are up to date."""
        poses = {name: world_from_cam(data, name) for name in self._lenses}
        views: dict[str, View] = {}
        for name, lens in self._lenses.items():
            views |= lens.views(name, poses[name])
        pictures = renderer.render(data, views)
        sights = {}
        for name, lens in self._lenses.items():
            geom, range_m = self._lines[name].gather([pictures[key] for key in lens.keys(name)])
            sights[name] = Sight(self._cameras[name], poses[name], self._lines[name], geom, range_m)
        rotations = data.geom_xmat.reshape(-1, 3, 3)
        return Survey(time_s, sights, np.concatenate([rotations, data.geom_xpos[..., None]], -1))
