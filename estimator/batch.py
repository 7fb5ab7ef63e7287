"""The batch estimator: what the online one does, and then the whole drive at once.

For calibration after the drive, and as the reference that the online estimator is measured against. While
the car drives, the answers are the online estimator's; ``close`` gives the better ones.
"""

from __future__ import annotations

from dataclasses import replace

from pydantic import Field

from estimator.belief import Belief
from estimator.bundle import FrameBundle
from estimator.config import Config
from estimator.estimate import Estimate
from estimator.factors import GraphConfig
from estimator.keyframe import Keyframe
from estimator.lens_config import Refine
from estimator.online import OnlineEstimator
from estimator.online_config import OnlineConfig
from estimator.rig import Rig
from estimator.scale import ScaleInformation, after_window
from estimator.stopwatch import Stopwatch
from estimator.window import WindowCalibration
from estimator.window_config import WindowConfig

_PATIENT = GraphConfig(iterations=30, relative_tolerance=1e-5)


class BatchConfig(Config):
    """Settings of the batch estimator.

    A drive of more than ``segment_keyframes`` is adjusted in segments, one after the other, each with what
    the ones before it taught as its prior: images are held for one segment at a time.
    """

    online: OnlineConfig = OnlineConfig()
    window: WindowConfig = WindowConfig(repeats=1, graph=_PATIENT)
    segment_keyframes: int = Field(100, ge=2, le=10_000)
    refine: Refine = "none"


class BatchEstimator:
    """Estimate the extrinsics of a rig from a whole drive.

    Sees bundles and the nominal rig, nothing else. Deterministic: the same bundles give the same bytes.
    """

    config_type = BatchConfig

    def __init__(self, rig: Rig, config: BatchConfig | None = None) -> None:
        self.config = config or BatchConfig()
        refine = self.config.online.refine if self.config.refine == "none" else self.config.refine
        self._refines = refine != "none"
        self._online = OnlineEstimator(rig, self.config.online.model_copy(update={"refine": refine}))
        self._belief = Belief.nominal(rig)
        self._scale_information: ScaleInformation = {}
        self._has_learnt = False
        self._segment: list[Keyframe] = []

    def update(self, bundle: FrameBundle) -> Estimate:
        """Follow the bundle as the online estimator does, and keep the keyframes."""
        estimate = self._online.update(bundle)
        if self._online.started:
            self._adjust_segment()
            self._segment = []
        if self._online.moved:
            self._forget(self._online.moved)
        if self._online.newest_keyframe is not None:
            self._segment.append(self._online.newest_keyframe)
        if len(self._segment) > self.config.segment_keyframes:
            self._adjust_segment()
            self._segment = self._segment[-1:]
        return estimate

    def close(self) -> Estimate:
        """Adjust what is left of the drive, and answer with all that the segments taught."""
        answer = self._online.close()
        self._adjust_segment()
        if not self._has_learnt:
            return answer
        belief = self._belief
        if self._refines:  # segments take lenses and clocks as refined; how unsure those are they do not know
            belief = replace(belief, covariance=self._online.belief.covariance)
        return self._online.final_answer(belief, self._scale_information)

    def _forget(self, moved: frozenset[str]) -> None:
        """Begin anew for cameras that moved: a segment knows one place for each."""
        nominal = Belief.nominal(self._belief.rig)
        for name in moved:
            self._belief = self._belief.forgetting((name,), nominal.camera_covariance(name))
        self._segment = self._segment[-1:]

    def _adjust_segment(self) -> None:
        """Adjust a segment as one window that starts from what the online estimator knows."""
        if len(self._segment) < self.config.online.pace.min_keyframes or not self._online.has_learnt:
            return
        poses = dict(self._online.path.poses())
        keyframes = [
            replace(k, world_from_ego=poses.get(k.stamp_ns, k.world_from_ego)) for k in self._segment
        ]
        start = self._online.belief.rig
        before = replace(self._belief, ahead_s=self._online.belief.ahead_s)
        result = WindowCalibration(
            keyframes, before, True, self.config.window, Stopwatch(), start=start
        ).run()
        if result is not None:
            self._belief, self._has_learnt = result.belief, True
            self._scale_information = after_window(self._scale_information, result.scale_information)
            corrected = result.path_from(keyframes[0].world_from_ego)
            self._online.path.correct([k.stamp_ns for k in keyframes], corrected)
