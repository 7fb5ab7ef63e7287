"""Follow the corners of one camera through its images.

The table of live tracks is a set of parallel arrays, so that the work for a frame is a handful of array
operations however many points there are.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from estimator.bundle import Image
from estimator.camera import Camera
from estimator.config import Config
from estimator.detect import DetectConfig, detect_corners
from estimator.flow import FlowConfig, follow
from estimator.se3 import SE3, Array

_FAR_M = 15.0  # the distance assumed of a point that has none yet and does not look at the road


def _ahead(rays_cam: Array) -> npt.NDArray[np.bool_]:
    """Tell which rays lie within 80 deg of the optical axis: beyond, the normalised plane is no use."""
    return np.asarray(rays_cam[:, 2] > 0.17)  # false for NaN


class TrackerConfig(Config):
    """Settings of one camera's tracker; long tracks drift and are given up after ``max_travel_m``.

    Tracks wait for a camera that misses up to ``bridged_images`` in a row. Those that disagree with the
    motion of the car ``max_strikes`` times in a row move by themselves, or have slipped to something else.
    """

    detect: DetectConfig = DetectConfig()
    flow: FlowConfig = FlowConfig()
    max_points: int = 220
    max_travel_m: float = 12.0
    min_parallax_rad: float = 0.012
    static_px: float = 0.4
    bridged_images: int = 4
    max_strikes: int = 3


class Tracker:
    """The live tracks of one camera: ids, pixels, rays, where each was first seen, and its point if known."""

    def __init__(self, camera: Camera, config: TrackerConfig) -> None:
        self.camera = camera
        self.config = config
        self.image: Image | None = None
        self.missed_count = 0
        self._next_id = 0
        self._allocate(0)

    def _allocate(self, count: int) -> None:
        self.ids = np.zeros(count, np.int64)
        self.pixels = np.zeros((count, 2))
        self.previous_pixels = np.zeros((count, 2))
        self.rays_cam = np.zeros((count, 3))
        self.anchor_rays_cam = np.zeros((count, 3))
        self.anchor_pixels = np.zeros((count, 2))
        self.anchor_rotation = np.zeros((count, 3, 3))
        self.anchor_center_world = np.full((count, 3), np.nan)
        self.points_world = np.full((count, 3), np.nan)
        self.fresh = np.zeros(count, bool)
        self.strikes = np.zeros(count, np.int64)

    _FIELDS = (
        "ids", "pixels", "previous_pixels", "rays_cam", "anchor_rays_cam", "anchor_pixels", "anchor_rotation",
        "anchor_center_world", "points_world", "fresh", "strikes",
    )  # fmt: skip

    def keep(self, chosen: npt.NDArray[np.bool_]) -> None:
        """Drop the tracks that are not chosen."""
        for name in self._FIELDS:
            setattr(self, name, getattr(self, name)[chosen])

    def advance(self, image: Image, guess_px: Array) -> None:
        """Move all tracks into ``image``; those that get lost are dropped."""
        if self.image is None or self.image.shape != image.shape:
            self._allocate(0)
        elif len(self.ids):
            moved, good = follow(self.image, image, self.pixels, guess_px, self.config.flow)
            self.previous_pixels, self.pixels = self.pixels, moved
            self.keep(good)
            self.rays_cam = self.camera.unproject(self.pixels)
            self.keep(_ahead(self.rays_cam))
        self.image = image
        self.missed_count = 0

    @property
    def current(self) -> bool:
        """Whether the tracks stand where the newest bundle shows them."""
        return self.missed_count == 0

    def miss(self) -> None:
        """Let the tracks wait: the camera gave no image; forget them if that goes on."""
        self.missed_count += 1
        if self.missed_count > self.config.bridged_images:
            self.forget()

    def forget(self) -> None:
        """Drop image and tracks."""
        self.image = None
        self._allocate(0)

    def replenish(self) -> None:
        """Start tracks where the image has corners and no track is."""
        room = self.config.max_points - len(self.ids)
        if self.image is None or room <= 0:
            return
        pixels = detect_corners(self.image, self.pixels, room, self.config.detect)
        rays = self.camera.unproject(pixels)
        usable = _ahead(rays)
        pixels, rays = pixels[usable], rays[usable]
        count = len(pixels)
        old = {name: getattr(self, name) for name in self._FIELDS}
        self._allocate(count)
        self.ids = np.arange(self._next_id, self._next_id + count)
        self._next_id += count
        self.pixels = self.previous_pixels = self.anchor_pixels = pixels
        self.rays_cam = self.anchor_rays_cam = rays
        self.fresh = np.ones(count, bool)
        for name in self._FIELDS:
            setattr(self, name, np.concatenate([old[name], getattr(self, name)]))

    def reanchor(self) -> None:
        """Count all tracks as first seen now."""
        self.anchor_rays_cam, self.anchor_pixels = self.rays_cam.copy(), self.pixels.copy()
        self.points_world[:] = np.nan
        self.fresh[:] = True

    def move_world(self, new_from_old: SE3, scale: float, origin_world: Array) -> None:
        """Take over a correction of the world: scaled about a point, then moved."""
        for points in (self.points_world, self.anchor_center_world):
            points[:] = new_from_old.apply(origin_world + scale * (points - origin_world))
        self.anchor_rotation = new_from_old.rotation @ self.anchor_rotation

    def anchor(self, world_from_cam: SE3) -> None:
        """Note where the newest tracks were first seen."""
        self.anchor_rotation[self.fresh] = world_from_cam.rotation
        self.anchor_center_world[self.fresh] = world_from_cam.translation
        self.fresh[:] = False

    def locate(self, world_from_cam: SE3) -> None:
        """Intersect each track's first ray with its newest one where the angle between them allows."""
        first = np.einsum("nij,nj->ni", self.anchor_rotation, self.anchor_rays_cam)
        last = self.rays_cam @ world_from_cam.rotation.T
        baseline = world_from_cam.translation - self.anchor_center_world
        cosine = np.clip(np.einsum("ni,ni->n", first, last), -1, 1)
        sine2 = np.maximum(1 - cosine**2, 1e-12)
        along_first = np.einsum("ni,ni->n", first, baseline)
        along_last = np.einsum("ni,ni->n", last, baseline)
        depth_first = (along_first - cosine * along_last) / sine2
        depth_last = (cosine * along_first - along_last) / sine2
        good = (np.arccos(cosine) > self.config.min_parallax_rad) & (depth_first > 0.3) & (depth_last > 0.3)
        middle = 0.5 * (self.anchor_center_world + depth_first[:, None] * first)
        middle += 0.5 * (world_from_cam.translation + depth_last[:, None] * last)
        self.points_world[good] = middle[good]

    def retire(self, world_from_cam: SE3) -> None:
        """Drop tracks that have come far, and those that stand still in the image while the car moves."""
        travel_m = np.linalg.norm(world_from_cam.translation - self.anchor_center_world, axis=1)
        moved_px = np.linalg.norm(self.pixels - self.anchor_pixels, axis=1)
        own_car = (travel_m > 3.0) & (moved_px < self.config.static_px * travel_m)
        self.keep(~((travel_m > self.config.max_travel_m) | own_car))

    @property
    def located(self) -> npt.NDArray[np.bool_]:
        """(N,) whether the place of each track's point is known."""
        return np.asarray(np.isfinite(self.points_world).all(1))

    def judge(self, agrees: npt.NDArray[np.bool_]) -> None:
        """Take what the motion of the car says of the located tracks, and drop those it keeps denying."""
        located = self.located
        self.strikes[located] = np.where(agrees, 0, self.strikes[located] + 1)
        self.keep(self.strikes < self.config.max_strikes)

    def predict(self, world_from_cam_before: SE3, world_from_cam: SE3) -> Array:
        """Return the (N, 2) pixels where the tracks should appear from a new pose.

        A track without a point is taken to lie on the road (world z = 0) if it looks at it within
        ``_FAR_M``, and at that distance otherwise.
        """
        ray_world = self.rays_cam @ world_from_cam_before.rotation.T
        center = world_from_cam_before.translation
        with np.errstate(divide="ignore", invalid="ignore"):
            to_road = np.where(ray_world[:, 2] < -0.02, -center[2] / ray_world[:, 2], np.inf)
        guess_m = np.clip(np.where(to_road > 0, to_road, _FAR_M), 0.5, _FAR_M)
        points = center + guess_m[:, None] * ray_world
        known = np.isfinite(self.points_world).all(1)
        points[known] = self.points_world[known]
        pixels = self.camera.project(world_from_cam.inverse().apply(points))
        stay = ~self.camera.contains(pixels, -100.0)
        pixels[stay] = self.pixels[stay]
        return pixels
