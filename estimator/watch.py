"""All that is watched besides the calibration itself, and the findings that come of it."""

from __future__ import annotations

from collections.abc import Sequence

from estimator.belief import Belief
from estimator.bundle import FrameBundle
from estimator.common_view import CommonViewConfig, CommonViewWatch
from estimator.config import Config
from estimator.finding import Finding
from estimator.front_end import FrontEnd
from estimator.image_watch import ImageWatch, ImageWatchConfig
from estimator.keyframe import Keyframe
from estimator.motion_watch import MotionWatch, MotionWatchConfig
from estimator.mount_watch import MountWatch, MountWatchConfig
from estimator.off_nominal import OffNominal
from estimator.prior_watch import PriorWatch, PriorWatchConfig
from estimator.rig import Rig
from estimator.stamp_watch import StampWatch, StampWatchConfig
from estimator.unsolved_watch import UnsolvedWatch, UnsolvedWatchConfig
from estimator.window_result import WindowResult


class WatchConfig(Config):
    """Settings of all that is watched."""

    image: ImageWatchConfig = ImageWatchConfig()
    stamps: StampWatchConfig = StampWatchConfig()
    motion: MotionWatchConfig = MotionWatchConfig()
    mount: MountWatchConfig = MountWatchConfig()
    common: CommonViewConfig = CommonViewConfig()
    prior: PriorWatchConfig = PriorWatchConfig()
    unsolved: UnsolvedWatchConfig = UnsolvedWatchConfig()


class Watch:
    """Sees every bundle and every window, and says what is wrong while it is."""

    def __init__(self, rig: Rig, config: WatchConfig, off_nominal: OffNominal) -> None:
        self._reference = rig.reference
        self._images = ImageWatch(rig, config.image)
        self._stamps = StampWatch(rig, config.stamps)
        self._motion = MotionWatch(config.motion)
        self._mounts = MountWatch(rig, config.mount)
        self._common = CommonViewWatch(rig, config.common)
        self._prior = PriorWatch(rig, config.prior, off_nominal)
        self._unsolved = UnsolvedWatch(rig.reference, config.unsolved)
        self._stamp_ns: int | None = None

    def admit(self, bundle: FrameBundle) -> FrameBundle | None:
        """Return what is usable of a bundle; None for one that is not newer than the last."""
        if self._stamp_ns is not None and bundle.stamp_ns <= self._stamp_ns:
            return None
        self._stamp_ns = bundle.stamp_ns
        return self._images.usable(bundle)

    def see_bundle(self, bundle: FrameBundle, front_end: FrontEnd) -> None:
        """Take note of a bundle that the front end has followed."""
        corner_count = {name: len(t.tracks) for name, t in front_end.trackers.items()}
        self._images.see(bundle, corner_count, front_end.repeats.names)
        self._motion.see(bundle, front_end)
        self._stamps.see(bundle)

    def see_window(self, keyframes: Sequence[Keyframe], before: Belief, result: WindowResult | None) -> None:
        """Take note of a window, of what was believed before it, and of what it taught, if anything."""
        self._mounts.see(keyframes)
        self._unsolved.see(keyframes, solved=result is not None)
        if result is not None:
            self._common.see(result.matches, result.inlier_count)
            self._prior.see(before, result.belief)

    def findings(self) -> tuple[Finding, ...]:
        """Return what holds now."""
        return (
            *self._images.findings(),
            *self._stamps.findings(),
            *self._motion.findings(self._reference),
            *self._mounts.findings(),
            *self._common.findings(),
            *self._prior.findings(),
            *self._unsolved.findings(),
        )


def doubted(findings: Sequence[Finding], rig: Rig) -> frozenset[str]:
    """Return the cameras whose poses are not to be relied on: all, where the reference is in doubt."""
    names = frozenset(name for finding in findings if finding.doubtful for name in finding.cameras)
    return frozenset(rig.cameras) if rig.reference in names else names
