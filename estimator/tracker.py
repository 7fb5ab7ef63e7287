"""Follow the corners of one camera through its images."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from estimator.ahead import is_ahead
from estimator.bundle import Image
from estimator.camera import Camera
from estimator.config import Config
from estimator.detect import DetectConfig, detect_corners
from estimator.flow import FlowConfig, follow
from estimator.own_car_mask import OwnCarConfig, OwnCarMask
from estimator.ranges import AngleRad, Count, LengthM, PositiveCount, SizeOrNonePx
from estimator.se3 import SE3, Array
from estimator.track_table import TrackTable

_IDLE_M = 3.0  # what has not moved after so long a way will not
_FAR_M = 15.0  # the distance assumed of a point that has none yet and does not look at the road


class TrackerConfig(Config):
    """Settings of one camera's tracker; long tracks drift and are given up after ``max_travel_m``.

    Tracks wait for a camera that misses up to ``bridged_images`` in a row. Those that disagree with the
    motion of the car ``max_strikes`` times in a row move by themselves, or have slipped to something else.
    """

    detect: DetectConfig = DetectConfig()
    flow: FlowConfig = FlowConfig()
    own_car: OwnCarConfig = OwnCarConfig()
    max_points: PositiveCount = 220
    max_travel_m: LengthM = 12.0
    min_parallax_rad: AngleRad = 0.012
    static_px: SizeOrNonePx = 0.4
    bridged_images: Count = 4
    max_strikes: PositiveCount = 3


class Tracker:
    """The live tracks of one camera, and the image they stand in."""

    def __init__(self, camera: Camera, config: TrackerConfig) -> None:
        self.camera = camera
        self.config = config
        self.image: Image | None = None
        self.missed_count = 0
        self.tracks = TrackTable()
        self.own_car = OwnCarMask(camera.size_px, config.own_car)

    def advance(self, image: Image, guess_px: Array) -> None:
        """Move all tracks into ``image``, from (N, 2) guesses; those that get lost are dropped."""
        tracks = self.tracks
        if self.image is None or self.image.shape != image.shape:
            tracks.clear()
        elif len(tracks):
            moved, good = follow(self.image, image, tracks.pixels, guess_px, self.config.flow)
            self._look_where_they_stood(image, moved, good)
            tracks.previous_pixels, tracks.pixels = tracks.pixels, moved
            tracks.keep(good)
            tracks.rays_cam = self.camera.unproject(tracks.pixels)
            tracks.keep(is_ahead(tracks.rays_cam))
        self.image = image
        self.missed_count = 0

    def _look_where_they_stood(self, image: Image, moved_px: Array, good: npt.NDArray[np.bool_]) -> None:
        """Find tracks of the car itself again, which are sought in vain where the street would have moved.

        They need to live for some metres to be told: else new ones would take the places with every image.
        """
        before_px = self.tracks.pixels
        rows = np.flatnonzero(~good & self.own_car.may_show_car(self.tracks))
        if self.image is None or len(rows) == 0:
            return
        found, back = follow(self.image, image, before_px[rows], before_px[rows], self.config.flow)
        stood = back & (np.linalg.norm(found - before_px[rows], axis=1) < self.config.own_car.still.still_px)
        moved_px[rows[stood]], good[rows[stood]] = found[stood], True

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
        self.tracks.clear()

    def replenish(self) -> None:
        """Start tracks where the image has corners and no track is."""
        room = self.config.max_points - len(self.tracks)
        if self.image is None or room <= 0:
            return
        usable = self.own_car.usable_px(*self.image.shape)
        pixels = detect_corners(self.image, self.tracks.pixels, room, self.config.detect, usable)
        rays = self.camera.unproject(pixels)
        usable = is_ahead(rays)
        self.tracks.start(pixels[usable], rays[usable])

    def locate(self, world_from_cam: SE3) -> None:
        """Place the points of tracks whose first and newest rays are far enough apart."""
        self.tracks.locate(world_from_cam, self.config.min_parallax_rad)

    def judge(self, agrees: npt.NDArray[np.bool_]) -> None:
        """Take what the motion of the car says of the located tracks, and drop those it keeps denying."""
        self.tracks.judge(agrees, self.config.max_strikes)

    def leave_own_car(self, world_from_ego: SE3, ego_from_cam: SE3, step_m: float) -> None:
        """Learn which parts of the image show the car itself, and drop the tracks that stand there."""
        focal_px = float(np.mean(self.camera.focal_px))
        self.tracks.keep(self.own_car.see(self.tracks, focal_px, world_from_ego, ego_from_cam, step_m))

    def retire(self, world_from_cam: SE3) -> None:
        """Drop tracks that have come far, and those that stand still while the car moves: they show nothing.

        Most of the latter are far ahead or sky; what stands still on the car itself is barred sooner.
        """
        tracks = self.tracks
        travel_m = np.linalg.norm(world_from_cam.translation - tracks.anchor_center_world, axis=1)
        moved_px = np.linalg.norm(tracks.pixels - tracks.anchor_pixels, axis=1)
        idle = (travel_m > _IDLE_M) & (moved_px < self.config.static_px * travel_m)
        tracks.keep(~((travel_m > self.config.max_travel_m) | idle))

    def predict(self, world_from_cam_before: SE3, world_from_cam: SE3) -> Array:
        """Return the (N, 2) pixels where the tracks should appear from a new pose.

        A track without a point is taken to lie on the road (world z = 0) if it looks at it within
        ``_FAR_M``, and at that distance otherwise.
        """
        tracks = self.tracks
        ray_world = tracks.rays_cam @ world_from_cam_before.rotation.T
        center = world_from_cam_before.translation
        with np.errstate(divide="ignore", invalid="ignore"):
            to_road = np.where(ray_world[:, 2] < -0.02, -center[2] / ray_world[:, 2], np.inf)
        guess_m = np.clip(np.where(to_road > 0, to_road, _FAR_M), 0.5, _FAR_M)
        points = center + guess_m[:, None] * ray_world
        known = tracks.located
        points[known] = tracks.points_world[known]
        pixels = self.camera.project(world_from_cam.inverse().apply(points))
        stay = ~self.camera.contains(pixels, -100.0)
        pixels[stay] = tracks.pixels[stay]
        return pixels
