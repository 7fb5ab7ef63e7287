"""Everything done with every bundle: follow the tracks of all cameras and keep the car's pose."""

from __future__ import annotations

import numpy as np

from estimator.bundle import FrameBundle, Image
from estimator.config import Config
from estimator.keyframe import Keyframe
from estimator.odometry import Odometry, OdometryConfig
from estimator.ranges import Count, LengthOrNoneM, Share
from estimator.repeats import Repeats
from estimator.rig import Rig
from estimator.rig_pose import RigPoseConfig, Sight, fit_rig_pose
from estimator.se3 import SE3, Array
from estimator.stopwatch import Stopwatch
from estimator.tracker import Tracker, TrackerConfig


class FrontEndConfig(Config):
    """Settings of the trackers and the odometry; when it counts as lost."""

    tracker: TrackerConfig = TrackerConfig()
    odometry: OdometryConfig = OdometryConfig()
    rig_pose: RigPoseConfig = RigPoseConfig()
    lost_after: Count = 3
    restart_below: Share = 0.5
    least_step_m: LengthOrNoneM = 0.02


class FrontEnd:
    """Trackers of all cameras around the odometry of the reference.

    Attributes:
        known: Whether the newest bundle's pose was measured, not guessed.
        repeats: Which images of the newest bundle their cameras had given before.
    """

    def __init__(self, rig: Rig, config: FrontEndConfig) -> None:
        self.rig = rig
        self.config = config
        self.odometry = Odometry(rig[rig.reference], config.odometry)
        self.trackers = {name: Tracker(m.camera, config.tracker) for name, m in rig.cameras.items()}
        self._bundle: FrameBundle | None = None
        self.repeats = Repeats()
        self._seen_from: dict[str, SE3] = {}  # where the car was at each camera's last image
        self._started_with = 0
        self._trusted: frozenset[str] = frozenset()  # whose pose on the car is known well enough to help
        self.known = False

    @property
    def metric(self) -> bool:
        """Whether the car's motion is known, in metres."""
        return self.odometry.metric

    def advance(self, bundle: FrameBundle, stopwatch: Stopwatch) -> bool:
        """Follow all tracks into a bundle; say whether this is a new start: the place motion counts from."""
        self._bundle = self._without_repeats(bundle)
        with stopwatch.stage("track"):
            self._follow(self.rig.reference, self.odometry.predicted_world_from_ego)
        with stopwatch.stage("motion"):
            self.known = self.odometry.advance(self.trackers[self.rig.reference])
        with stopwatch.stage("track"):
            for name in self.rig.estimated_names:
                self._follow(name, self.odometry.world_from_ego)
        with stopwatch.stage("motion"):
            self._ask_all_cameras()
        self._seen_from |= dict.fromkeys(self._bundle.images, self.odometry.world_from_ego)
        with stopwatch.stage("detect"):
            return self._renew()

    def keyframe(self) -> Keyframe:
        """Return the newest bundle as a keyframe."""
        assert self._bundle is not None, "advance comes first"
        current = {name: t for name, t in self.trackers.items() if t.current}
        street = {name: ~t.tracks.on_car for name, t in current.items()}
        tracks = {n: (t.tracks.ids[street[n]], t.tracks.pixels[street[n]]) for n, t in current.items()}
        images = dict(self._bundle.images)
        return Keyframe(self._bundle.stamp_ns, images, self.odometry.world_from_ego, tracks)

    def live_tracks_px(self) -> dict[str, Array]:
        """Return by camera (N, 4) previous and present pixels."""
        return {
            name: np.hstack([t.tracks.previous_pixels, t.tracks.pixels]) if t.current else np.zeros((0, 4))
            for name, t in self.trackers.items()
        }

    def correct(self, rig: Rig, trusted: frozenset[str], new_from_old: SE3, scale: float) -> None:
        """Take over a better rig, which of it is good, and a better place for the newest keyframe."""
        reference = rig[rig.reference].ego_from_cam
        pose = self.odometry.world_from_ego
        origin = (pose @ reference).translation
        for name, tracker in self.trackers.items():
            tracker.tracks.move_world(new_from_old, scale, origin)
            tracker.camera = rig[name].camera
        self._seen_from = {name: new_from_old @ old for name, old in self._seen_from.items()}
        self.odometry.correct(new_from_old @ pose, scale)
        self.rig, self._trusted = rig, trusted

    def _ask_all_cameras(self) -> None:
        """Fit the pose of the car to what all trusted cameras see, and drop tracks that keep denying it."""
        asked = {name: t for name, t in self.trackers.items() if name in self._trusted and t.current}
        if not self.metric or len(asked) < 2:
            return
        tables = {name: tracker.tracks for name, tracker in asked.items()}
        sights = {name: Sight(t.rays_cam[t.located], t.points_world[t.located]) for name, t in tables.items()}
        fitted = fit_rig_pose(self.rig, sights, self.odometry.world_from_ego, self.config.rig_pose)
        if fitted is None:
            return
        self.odometry.settle(fitted.world_from_ego)
        self.known = True
        for name, agrees in fitted.agrees.items():
            asked[name].judge(agrees)

    def _without_repeats(self, bundle: FrameBundle) -> FrameBundle:
        """Leave out images that a moving car cannot have seen: the camera's last one once more, to the byte.

        They come from a camera that hangs; taken for the world, they show landmarks at infinity.
        """
        self.repeats.see(bundle)
        repeats = self.repeats.names
        if not repeats or self.odometry.step_m < self.config.least_step_m:
            return bundle
        images = {name: image for name, image in bundle.images.items() if name not in repeats}
        return FrameBundle(bundle.stamp_ns, images)

    def _follow(self, name: str, world_from_ego: SE3) -> None:
        assert self._bundle is not None
        tracker = self.trackers[name]
        image: Image | None = self._bundle.images.get(name)
        if image is None:
            tracker.miss()
            return
        ego_from_cam = self.rig[name].ego_from_cam
        before = self._seen_from.get(name, world_from_ego)
        guess = tracker.predict(before @ ego_from_cam, world_from_ego @ ego_from_cam)
        tracker.advance(image, guess)

    def _renew(self) -> bool:
        """Place points, drop old tracks and start new ones; before the motion is known, only at a start.

        Tracks that wait for an image are left alone, and all are while the pose is a guess.
        """
        if not self.known and self.odometry.lost_count > self.config.lost_after:
            self.odometry.restart()
        starting = not self.metric and self._must_start()
        for name, tracker in self.trackers.items():
            if starting and not tracker.current:
                tracker.forget()
            elif starting or (self.known and tracker.current):
                self._renew_one(tracker, self.rig[name].ego_from_cam, starting)
        if starting:
            self._started_with = len(self.trackers[self.rig.reference].tracks)
        return starting

    def _renew_one(self, tracker: Tracker, ego_from_cam: SE3, starting: bool) -> None:
        world_from_ego = self.odometry.world_from_ego
        world_from_cam = world_from_ego @ ego_from_cam
        if starting:
            tracker.tracks.reanchor()
        else:
            tracker.locate(world_from_cam)
            tracker.leave_own_car(world_from_ego, ego_from_cam, self.odometry.step_m)
            tracker.retire(world_from_cam)
        tracker.replenish()
        tracker.tracks.anchor(world_from_cam)

    def _must_start(self) -> bool:
        left = len(self.trackers[self.rig.reference].tracks)
        return left <= self.config.restart_below * self._started_with
