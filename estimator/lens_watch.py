"""Watch lenses and clocks while the car drives: gather every window's evidence, and correct where asked.

A lens that is far off makes the adjustment distrust the very sightings that show it, so one linearisation
overstates or understates the error. The window is therefore adjusted again with the lens as found, until
it no longer changes.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Literal

import numpy as np
from pydantic import Field

from estimator.belief import Belief
from estimator.camera import Camera
from estimator.config import Config
from estimator.corridor import road_landmarks
from estimator.evidence import Evidence, Posterior, UsualErrors, differences
from estimator.factors import GraphConfig, Loss
from estimator.finding import Finding, FindingKind
from estimator.graph import adjust
from estimator.lens_findings import AccusationConfig, accusations
from estimator.observations import Observations
from estimator.rig import Rig
from estimator.scene import Scene
from estimator.unknowns import Unknowns
from estimator.window_information import window_information

Refine = Literal["none", "intrinsics"]
_HELD_S = 1e-7  # a clock that is taken as right


class LensConfig(Config):
    """What is usual, what is told, and when a window is adjusted again.

    A lens has settled once a round changes it by less than these.
    """

    usual: UsualErrors = UsualErrors()
    accuse: AccusationConfig = AccusationConfig()
    rounds: int = Field(4, ge=0)
    settled_focal_share: float = 2e-4
    settled_center_px: float = 0.1
    loss_px: float = 0.1
    road_tolerance_m: float = 0.08
    graph: GraphConfig = GraphConfig()


class LensWatch:
    """The evidence on lenses and clocks so far.

    Attributes:
        findings: The lenses and clocks that are clearly wrong.
        belief: The extrinsics by all windows' evidence, with the lenses as corrected.
        lenses: The corrected lenses by camera; empty while none are known.
    """

    def __init__(self, nominal: Rig, config: LensConfig, refine: Refine) -> None:
        self.config = config
        self.refine = refine
        self.findings: tuple[Finding, ...] = ()
        self.belief = Belief.nominal(nominal)
        self.lenses: Mapping[str, Camera] = {}
        self._evidence = Evidence.none(nominal)
        self._unknowns = Unknowns(nominal)

    def learn(self, scene: Scene, seen: Observations, stamps_ns: Sequence[int]) -> None:
        """Add a window, given as it was adjusted; adjust it again where a lens must change."""
        for _ in range(self.config.rounds):
            evidence = self._with(scene, seen, stamps_ns)
            target = self._corrected(scene.rig, evidence)
            if self._is_settled(scene.rig, target):
                break
            scene = replace(scene, rig=target)
            try:
                for loss_px in (5 * self.config.loss_px, self.config.loss_px):
                    on_road = road_landmarks(scene, seen, self.config.road_tolerance_m)
                    scene = adjust(scene, seen, on_road, self.belief, Loss(loss_px), self.config.graph).scene
            except RuntimeError:  # GTSAM: an indeterminate system; what was known before stays
                return
        self._evidence = self._with(scene, seen, stamps_ns)
        self.findings = tuple(map(self._as_told, self._accuse(self._evidence)))
        self.belief = self._believed()
        if self.refine != "none":
            self.lenses = {name: mounted.camera for name, mounted in self.belief.rig.cameras.items()}

    def _as_told(self, finding: Finding) -> Finding:
        """Return the finding; a lens that is corrected spoils no pose."""
        if finding.kind is not FindingKind.WRONG_INTRINSICS or self.refine == "none":
            return finding
        return replace(finding, about=f"{finding.about}; corrected", doubtful=False)

    def _believed(self) -> Belief:
        posterior = self._held(self._evidence)
        size = self._unknowns.pose_size
        covariance = posterior.covariance[:size, :size] * max(1.0, posterior.disagreement)
        return Belief(self._corrected(self._evidence.nominal, self._evidence), covariance)

    def _with(self, scene: Scene, seen: Observations, stamps_ns: Sequence[int]) -> Evidence:
        on_road = road_landmarks(scene, seen, self.config.road_tolerance_m)
        loss, graph = Loss(self.config.loss_px), self.config.graph
        found = window_information(scene, seen, on_road, stamps_ns, loss, graph, curved=True)
        return self._evidence.with_window(found, scene.rig)

    def _accuse(self, evidence: Evidence) -> tuple[Finding, ...]:
        return accusations(evidence.posterior(self.config.usual), evidence.nominal, self.config.accuse)

    def _held(self, evidence: Evidence) -> Posterior:
        """Return the posterior with clocks taken as right: what poses and lenses are refined by."""
        return evidence.posterior(self.config.usual.model_copy(update={"clock_s": _HELD_S}))

    def _corrected(self, rig: Rig, evidence: Evidence) -> Rig:
        """Return the rig with poses as now known and, where asked for or else where accused, its lenses.

        Poses move along with lenses, else the next adjustment would start from an error that those make.
        """
        wrong = set(rig.cameras)
        if self.refine == "none":
            accused = [f for f in self._accuse(evidence) if f.kind is FindingKind.WRONG_INTRINSICS]
            wrong = {name for finding in accused for name in finding.cameras}
        posterior = self._held(evidence)
        return _with_lenses(_with_poses(rig, posterior, self._unknowns), posterior, self._unknowns, wrong)

    def _is_settled(self, rig: Rig, target: Rig) -> bool:
        change = np.abs(
            differences(self._evidence.nominal, target) - differences(self._evidence.nominal, rig)
        )
        limit = (self.config.settled_focal_share, *[self.config.settled_center_px] * 2)
        return all(
            bool((change[self._unknowns.lens(camera)] < limit).all())
            for camera in range(len(self._unknowns.names))
        )


def _with_poses(rig: Rig, posterior: Posterior, unknowns: Unknowns) -> Rig:
    return rig.with_extrinsics(
        {
            name: unknowns.rig[name].ego_from_cam.retract(posterior.mean[unknowns.extrinsics(camera)])
            for camera, name in enumerate(unknowns.names)
            if name in unknowns.estimated
        }
    )


def _with_lenses(rig: Rig, posterior: Posterior, unknowns: Unknowns, names: Iterable[str]) -> Rig:
    cameras = dict(rig.cameras)
    for name in names:
        log_focal, *shift = posterior.mean[unknowns.lens(unknowns.names.index(name))]
        stated = unknowns.rig[name].camera
        focal_x, focal_y = np.array(stated.focal_px) * np.exp(log_focal)
        center_x, center_y = np.add(stated.center_px, shift)
        lens = replace(
            stated,
            focal_px=(float(focal_x), float(focal_y)),
            center_px=(float(center_x), float(center_y)),
        )
        cameras[name] = replace(cameras[name], camera=lens)
    return replace(rig, cameras=cameras)
