"""The online estimator: tracks with every bundle, a window now and then, one belief for ever."""

from __future__ import annotations

import numpy as np

from estimator.belief import Belief
from estimator.bundle import FrameBundle
from estimator.estimate import Estimate, Match
from estimator.factors import flattened
from estimator.front_end import FrontEnd
from estimator.keyframe import Keyframe
from estimator.ledger import Ledger
from estimator.lens_watch import LensWatch
from estimator.move_watch import MoveWatch
from estimator.online_config import OnlineConfig
from estimator.path import Path
from estimator.rig import Rig
from estimator.scale import ScaleInformation
from estimator.se3 import SE3
from estimator.stopwatch import Stopwatch
from estimator.watch import Watch
from estimator.window import WindowCalibration
from estimator.window_pace import is_keyframe
from estimator.window_result import WindowResult


class OnlineEstimator:
    """Estimate the extrinsics of a rig while the car drives.

    Sees bundles and the nominal rig, nothing else. Deterministic: the same bundles give the same bytes.

    Attributes:
        belief: The extrinsics as known so far.
        path: Where the car was, in a world of the estimator's own.
        newest_keyframe: The newest bundle, if it was kept as a keyframe.
        moved: The cameras that were just found to have moved on the car.
        started: Whether motion counts from the newest bundle: nothing is known of how the car came there.
    """

    config_type = OnlineConfig

    def __init__(self, rig: Rig, config: OnlineConfig | None = None) -> None:
        self.config = config or OnlineConfig()
        self.belief = Belief.nominal(rig)
        self._front_end = FrontEnd(rig, self.config.front_end)
        self._lens_watch = LensWatch(rig, self.config.lens, self.config.window, self.config.refine)
        self._keyframes: list[Keyframe] = []
        self.path = Path()
        self.newest_keyframe: Keyframe | None = None
        self.started = False
        self.moved: frozenset[str] = frozenset()
        self._ledger = Ledger(rig, self.config.ledger, self.config.off_nominal)
        self._stamp_ns = 0
        self._watch = Watch(rig, self.config.watch, self.config.off_nominal)
        self._moves = MoveWatch(self.config.moves, self.config.window, self.config.ledger.shared_scale_sigma)

    def update(self, bundle: FrameBundle) -> Estimate:
        """Follow the bundle; when a window is full, calibrate from it."""
        stopwatch = Stopwatch()
        self.newest_keyframe, self.started, self.moved = None, False, frozenset()
        usable = self._watch.admit(bundle)
        if usable is None:
            return self._estimate(stopwatch, ())
        bundle, self._stamp_ns = usable, usable.stamp_ns
        self.started = self._front_end.advance(bundle, stopwatch)
        with stopwatch.stage("watch"):
            self._watch.see_bundle(bundle, self._front_end)
        if self.started:
            self.newest_keyframe = self._front_end.keyframe()
            self._keyframes = [self.newest_keyframe]
            self.path.begin(bundle.stamp_ns, self._front_end.odometry.world_from_ego)
        elif self._front_end.metric:
            here = self._front_end.odometry.world_from_ego
            self.path.append(bundle.stamp_ns, here, self._front_end.known)
        if self._front_end.known and is_keyframe(self._keyframes, self._front_end.odometry, self.config.pace):
            self.newest_keyframe = self._front_end.keyframe()
            self._keyframes.append(self.newest_keyframe)
        matches: tuple[Match, ...] = ()
        if len(self._keyframes) >= self._window_length():
            matches = self._calibrate(stopwatch)
        return self._estimate(stopwatch, matches)

    def close(self) -> Estimate:
        """Calibrate from what the last, unfinished window holds, and answer with the refined path."""
        stopwatch = Stopwatch()
        matches: tuple[Match, ...] = ()
        if len(self._keyframes) >= self.config.pace.min_keyframes:
            matches = self._calibrate(stopwatch)
        return self._estimate(stopwatch, matches, closing=True)

    @property
    def has_learnt(self) -> bool:
        """Whether any window has been solved."""
        return not self._ledger.is_empty

    def final_answer(self, belief: Belief, scale_information: ScaleInformation) -> Estimate:
        """Return what ``close`` would, had the windows taught this belief."""
        self.belief, self._ledger.scale_information = belief, scale_information
        return self._estimate(Stopwatch(), (), closing=True)

    def _window_length(self) -> int:
        return self.config.pace.keyframes if self.has_learnt else self.config.pace.first_keyframes

    def _calibrate(self, stopwatch: Stopwatch) -> tuple[Match, ...]:
        """Solve the window, fuse what it taught, and start the next one at its last keyframe."""
        keyframes, self._keyframes = self._keyframes, self._keyframes[-1:]
        calibration = WindowCalibration(
            keyframes, self.belief, self.has_learnt, self.config.window, stopwatch
        )
        result = calibration.run()
        with stopwatch.stage("watch"):
            self._watch.see_window(keyframes, self.belief, result)
        if result is None:
            return ()
        with stopwatch.stage("lens"):
            if not self._moves.in_doubt:
                self._lens_watch.hold()
            self._lens_watch.learn(result.scene, result.seen)
        with stopwatch.stage("moves"):
            result = self._without_moves(result)
        with stopwatch.stage("fuse"):
            self.belief = self._lens_watch.corrected or result.belief
            self._correct_motion(keyframes, result)
            self._ledger.add(result)
        return result.matches

    def _without_moves(self, result: WindowResult) -> WindowResult:
        """Return the result without what cameras spoil that no longer sit where they did."""
        try:
            examined = self._moves.examine(self.belief, result, self._lens_watch.blamed)
        except (RuntimeError, np.linalg.LinAlgError):  # by itself the window cannot be solved: no opinion
            return result
        result = examined.result
        if examined.moved:
            self._lens_watch.relearn(examined.moved, result.scene, result.seen)
            self._ledger.forget(examined.moved)
        self.moved |= examined.moved
        return result

    def _correct_motion(self, keyframes: list[Keyframe], result: WindowResult) -> None:
        """Move path, tracks and odometry to where the window found the car to be."""
        first, last = result.scene.world_from_egos[0], result.scene.world_from_egos[-1]
        if self._ledger.is_empty:  # the first window says how level the car stood when it started
            flat = flattened(keyframes[0].world_from_ego)
            world_from_first = SE3(flat.rotation @ first.rotation, keyframes[0].world_from_ego.translation)
        else:
            world_from_first = keyframes[0].world_from_ego
        corrected = result.path_from(world_from_first)
        old_last = keyframes[-1].world_from_ego
        new_from_old = corrected[-1] @ old_last.inverse()
        old_m = float(np.linalg.norm((keyframes[0].world_from_ego.inverse() @ old_last).translation))
        new_m = float(np.linalg.norm((first.inverse() @ last).translation))
        self.path.correct([k.stamp_ns for k in keyframes], corrected)
        trusted = self.belief.known_within(self.config.window.unsure_rad) - self._moves.in_doubt
        self._front_end.correct(self.belief.rig, trusted, new_from_old, new_m / max(old_m, 1e-6))
        self._keyframes = [
            Keyframe(keyframes[-1].stamp_ns, keyframes[-1].images, corrected[-1], keyframes[-1].tracks)
        ]

    def _estimate(
        self, stopwatch: Stopwatch, matches: tuple[Match, ...], *, closing: bool = False
    ) -> Estimate:
        findings = (*self._watch.findings(), *self._moves.findings(), *self._lens_watch.findings)
        missed = {name: tracker.missed_count for name, tracker in self._front_end.trackers.items()}
        lenses, doubt = self._lens_watch.lenses, self._lens_watch.doubt
        cameras = self._ledger.cameras(self.belief, missed, findings, lenses, doubt)
        return Estimate(
            self._stamp_ns,
            cameras,
            self.path.newest if self._front_end.metric else None,
            self.path.poses() if closing else (),
            self._front_end.live_tracks_px(),
            matches,
            stopwatch.seconds,
            findings,
            self._ledger.scale(),
        )
