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
from estimator.finding import Finding, FindingKind
from estimator.keyframe import Keyframe
from estimator.lens_config import Refine
from estimator.online import OnlineEstimator
from estimator.online_config import OnlineConfig
from estimator.ranges import PositiveShare, RepeatCount, StepCount
from estimator.rig import Rig
from estimator.scale import ScaleInformation, after_window
from estimator.stopwatch import Stopwatch
from estimator.window import WindowCalibration
from estimator.window_config import WindowConfig


class BatchConfig(Config):
    """Settings of the batch estimator.

    A drive of more than ``segment_keyframes`` is adjusted in segments, one after the other, each with what
    the ones before it taught as its prior: images are held for one segment at a time. A segment is adjusted
    as ``online.window`` says, only more patiently.
    """

    online: OnlineConfig = OnlineConfig()
    repeats: RepeatCount = 1
    iterations: StepCount = 30
    relative_tolerance: PositiveShare = 1e-5
    segment_keyframes: int = Field(100, ge=2, le=10_000)
    refine: Refine = "none"

    @property
    def window(self) -> WindowConfig:
        """How a segment is adjusted."""
        window, patience = self.online.window, ("iterations", "relative_tolerance")
        graph = window.graph.model_copy(update={name: getattr(self, name) for name in patience})
        return window.model_copy(update={"repeats": self.repeats, "graph": graph})


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
        self._segment_count = self._failed_count = 0
        self._reference = rig.reference

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
            return self._with_failures(answer)
        belief = self._belief
        if self._refines:  # segments take lenses and clocks as refined; how unsure those are they do not know
            belief = replace(belief, covariance=self._online.belief.covariance)
        return self._with_failures(self._online.final_answer(belief, self._scale_information))

    def _with_failures(self, answer: Estimate) -> Estimate:
        if not self._failed_count:
            return answer
        rest = "the others" if self._has_learnt else "what the windows taught"
        about = (
            f"{self._failed_count} of {self._segment_count} segments of the drive could not be adjusted as a "
            f"whole: the answer rests on {rest}"
        )
        failed = Finding(FindingKind.UNSOLVED_WINDOWS, (self._reference,), about, doubtful=False)
        return replace(answer, findings=(*answer.findings, failed))

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
        self._segment_count += 1
        if result is None:
            self._failed_count += 1
        else:
            self._belief, self._has_learnt = result.belief, True
            self._scale_information = after_window(self._scale_information, result.scale_information)
            corrected = result.path_from(keyframes[0].world_from_ego)
            self._online.path.correct([k.stamp_ns for k in keyframes], corrected)
