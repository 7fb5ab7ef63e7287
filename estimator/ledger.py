"""What the windows have shown of each camera so far, and how far that lets its pose be relied on."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from estimator.belief import Belief
from estimator.camera import Camera
from estimator.clock_doubt import ClockDoubt
from estimator.config import Config
from estimator.estimate import ALL_AXES, Axes, CameraEstimate, Status
from estimator.finding import Finding, FindingKind
from estimator.observability import ObservabilityConfig, observed_axes, weak_words
from estimator.off_nominal import OffNominal
from estimator.ranges import Share
from estimator.rig import Rig
from estimator.scale import ScaleEvidence, ScaleInformation, after_window, scale_evidence
from estimator.status import StatusConfig, is_lost, judge
from estimator.watch import doubted
from estimator.window_result import WindowResult


class LedgerConfig(Config):
    """How evidence becomes a statement.

    ``shared_scale_sigma`` is the relative error of scale that all windows of a drive share.
    """

    shared_scale_sigma: Share = 0.0015
    status: StatusConfig = StatusConfig()
    observability: ObservabilityConfig = ObservabilityConfig()


class Ledger:
    """Grows with every window that was believed; its size does not.

    Attributes:
        scale_information: What each source has said of scale so far.
    """

    def __init__(self, nominal: Rig, config: LedgerConfig, off_nominal: OffNominal) -> None:
        self.config = config
        self._off_nominal = off_nominal
        self.scale_information: ScaleInformation = {}
        self._nominal = nominal
        self._prior = Belief.nominal(nominal)
        self._inliers = dict.fromkeys(nominal.cameras, 0)
        self._links = dict.fromkeys(nominal.cameras, 0)
        self._newest: Mapping[str, int] | None = None

    @property
    def is_empty(self) -> bool:
        """Whether no window has been believed yet."""
        return self._newest is None

    def add(self, result: WindowResult) -> None:
        """Take down what a window has shown."""
        self.scale_information = after_window(self.scale_information, result.scale_information)
        self._newest = result.inlier_count
        for name, count in result.inlier_count.items():
            self._inliers[name] += count
            self._links[name] += result.link_count[name]

    def forget(self, names: Collection[str]) -> None:
        """Count nothing for cameras that was seen before they moved."""
        for name in names:
            self._inliers[name] = self._links[name] = 0

    def scale(self) -> ScaleEvidence | None:
        """Return what is known of metric scale."""
        return scale_evidence(self.scale_information, self.config.shared_scale_sigma)

    def cameras(
        self,
        belief: Belief,
        missed: Mapping[str, int],
        findings: tuple[Finding, ...],
        lenses: Mapping[str, Camera],
        doubt: ClockDoubt,
    ) -> dict[str, CameraEstimate]:
        """State every camera's pose.

        Args:
            belief: What is believed of the extrinsics.
            missed: By camera, how many bundles in a row came without its image.
            findings: What was noticed.
            lenses: Refined intrinsics by camera, if any.
            doubt: What clocks leave open.
        """
        stated = belief
        if not self.is_empty:
            stated = belief.with_scale_sigma(self.config.shared_scale_sigma).widened(doubt.covariance)
        in_doubt = doubted(findings, self._nominal)
        moved = {name for f in findings if f.kind is FindingKind.MOVED_CAMERA for name in f.cameras}
        has_wrong_lens = any(f.doubtful and f.kind is FindingKind.WRONG_INTRINSICS for f in findings)
        estimates = {}
        for name in belief.rig.cameras:
            pose = belief.rig[name].ego_from_cam
            covariance, prior = belief.camera_covariance(name), self._prior.camera_covariance(name)
            is_reference = name == belief.rig.reference
            limits = self.config.observability
            hidden = doubt.hidden_of(name, belief.rig)
            observed = ALL_AXES if is_reference else observed_axes(covariance, prior, limits, hidden)
            weak_axes = () if is_reference else weak_words(observed, covariance, prior, pose, limits, hidden)
            status = self._status(name, stated, missed[name], observed)
            if name in in_doubt and status not in (Status.LOST, Status.INITIALISING):
                status = Status.SUSPECT
            elif has_wrong_lens and status is Status.CONVERGED and not is_reference:
                status = Status.WEAK  # its neighbours share landmarks with it, and are pulled along
            elif name in moved and status is Status.WEAK:
                status = Status.MOVED
            estimates[name] = CameraEstimate(
                pose, stated.camera_covariance(name), status, self._inliers[name], observed, weak_axes,
                lenses.get(name),
            )  # fmt: skip
        return estimates

    def _status(self, name: str, stated: Belief, missed: int, observed: Axes) -> Status:
        """Return the status that the windows' evidence gives, whatever else was noticed.

        The reference's pose is known; what may be wanting is evidence that the camera still sees from there.
        """
        limits = self.config.status
        if self._newest is None:
            return Status.INITIALISING
        links, newest = self._links[name], self._newest[name]
        if name == stated.rig.reference:
            return Status.LOST if is_lost(newest, missed, limits) else Status.CONVERGED
        return judge(name, stated, self._nominal, links, newest, missed, limits, observed, self._off_nominal)
