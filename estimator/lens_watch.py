"""Watch lenses and clocks while the car drives: gather every window's evidence, and correct where asked.

A lens or clock that is far off makes the adjustment distrust the very sightings that show it, so one
linearisation misstates the error. The window is therefore adjusted again with lens or clock as found,
until it no longer changes.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import Literal

import numpy as np
from pydantic import Field

from estimator.belief import Belief
from estimator.camera import Camera
from estimator.clock_doubt import ClockDoubt, ClockDoubtConfig, clock_doubt
from estimator.clock_or_shift import ClockOrShiftConfig, late_or_shifted
from estimator.clocks import Clocks
from estimator.config import Config
from estimator.corrections import belief_from, scene_at
from estimator.corridor import road_landmarks
from estimator.evidence import Evidence, Free, UsualErrors, differences
from estimator.finding import Finding, FindingKind
from estimator.graph import adjust
from estimator.lens_findings import AccusationConfig, accusations
from estimator.loss import Loss
from estimator.observations import Observations
from estimator.ranges import Factor, PositiveShare
from estimator.rig import Rig
from estimator.scene import Scene
from estimator.unknowns import Unknowns
from estimator.window_config import WindowConfig
from estimator.window_information import window_information

Refine = Literal["none", "intrinsics", "clocks", "both"]


class LensConfig(Config):
    """What is usual, what is told, and when a window is adjusted again.

    Lens and clock have settled once a round changes them by less than ``settled`` times the usual error.
    ``clocks_in_step`` says that one trigger or one clock serves all cameras: then what a late clock could do
    is left out of what is stated of poses. A clock that is clearly late is told all the same.
    """

    usual: UsualErrors = UsualErrors()
    accuse: AccusationConfig = AccusationConfig()
    suspect_sigmas: Factor = 3.0
    rounds: int = Field(6, ge=0, le=100)
    settled: PositiveShare = 0.03
    clocks_in_step: bool = False
    doubt: ClockDoubtConfig = ClockDoubtConfig()
    late_or_shifted: ClockOrShiftConfig = ClockOrShiftConfig()


class LensWatch:
    """The evidence on lenses and clocks so far.

    Attributes:
        findings: The lenses and clocks that are clearly wrong, and clocks that would explain a far shift.
        belief: The extrinsics by all windows' evidence, with lenses and clocks as corrected.
        lenses: The refined lenses by camera; empty while none are known.
        doubt: What clocks leave open of the extrinsics.
    """

    def __init__(self, nominal: Rig, config: LensConfig, window: WindowConfig, refine: Refine) -> None:
        self.config = config
        self.window = window
        self.refine = refine
        self.findings: tuple[Finding, ...] = ()
        self.belief = Belief.nominal(nominal)
        self.lenses: Mapping[str, Camera] = {}
        self._evidence = self._held = Evidence.none(nominal)
        self.doubt = self._doubt()

    def learn(self, scene: Scene, seen: Observations) -> None:
        """Add a window, given as it was adjusted; adjust it again where a lens or clock must change."""
        if scene.clocks is None:
            scene = replace(scene, clocks=Clocks(scene.stamps_ns, (0.0,) * len(scene.rig.cameras)))
        try:
            self._evidence = self._settled(scene, seen)
        except (RuntimeError, np.linalg.LinAlgError):  # no solution: what was known before stays
            return
        self.belief = belief_from(self._evidence, self.config.usual, self._free(self._evidence))
        self.doubt = self._doubt()
        self.findings = self._findings()
        if self._refines_lenses:
            self.lenses = {name: mounted.camera for name, mounted in self.belief.rig.cameras.items()}

    def hold(self) -> None:
        """Keep what is known now, for ``relearn`` to come back to."""
        self._held = self._evidence

    def relearn(self, moved: Collection[str], scene: Scene, seen: Observations) -> None:
        """Learn a window in place of all since ``hold``, after which cameras have moved on the car."""
        self._evidence = self._held
        for name in moved:
            self._evidence = self._evidence.forgetting_pose(name)
        self.learn(scene, seen)

    @property
    def blamed(self) -> frozenset[str]:
        """The cameras whose lens or clock is in doubt, so that their poses seem to change."""
        return frozenset(name for f in self.findings if f.doubtful for name in f.cameras)

    @property
    def _loss(self) -> Loss:
        """The loss that the window was adjusted with at last."""
        return Loss(self.window.sighting_noise.loss_sigmas, of_sigma=True)

    @property
    def corrected(self) -> Belief | None:
        """What to believe where lenses or clocks are to be corrected; None if not, or if nothing is known."""
        if self.refine == "none" or not self._evidence.window_count:
            return None
        belief = self.belief
        if not self._refines_clocks:
            belief = replace(belief, ahead_s={})
        if not self._refines_lenses:
            poses = {name: mounted.ego_from_cam for name, mounted in belief.rig.cameras.items()}
            belief = replace(belief, rig=self._evidence.nominal.with_extrinsics(poses))
        return belief

    @property
    def _refines_lenses(self) -> bool:
        return self.refine in ("intrinsics", "both")

    @property
    def _refines_clocks(self) -> bool:
        return self.refine in ("clocks", "both")

    def _findings(self) -> tuple[Finding, ...]:
        """Return accusations; where only the rig file's prior speaks against a clock, both explanations."""
        config, evidence = self.config, self._evidence
        either = late_or_shifted(
            evidence, self.doubt, config.doubt.broad_s, config.usual, config.late_or_shifted
        )
        unclear = {finding.cameras for finding in either}
        accused = map(self._as_told, self._accuse(evidence, config.accuse))
        clear = (f for f in accused if f.kind is not FindingKind.CLOCK_OFFSET or f.cameras not in unclear)
        return (*clear, *either)

    def _doubt(self) -> ClockDoubt:
        if self.config.clocks_in_step:
            return ClockDoubt.none(self._evidence.nominal)
        corrected = self._free(self._evidence).clocks if self._refines_clocks else frozenset[str]()
        return clock_doubt(self._evidence, self.config.usual, self.config.doubt, corrected)

    def _settled(self, scene: Scene, seen: Observations) -> Evidence:
        """Return all evidence, the window's at lenses and clocks that it no longer changes."""
        evidence = self._evidence
        free = self._free(evidence)
        if evidence.window_count and not self._is_settled(scene, free, evidence):
            scene = self._adjusted(scene, seen, free, evidence)
        evidence = self._with(scene, seen)
        for _ in range(self.config.rounds):
            free = self._free(evidence)
            if self._is_settled(scene, free, evidence):
                break
            # The loss's own curvature would step too far while residuals are large.
            scene = self._adjusted(scene, seen, free, self._with(scene, seen, curved=False))
            evidence = self._with(scene, seen)
        return evidence

    def _is_settled(self, scene: Scene, free: Free, evidence: Evidence) -> bool:
        nominal, usual, unknowns = evidence.nominal, self.config.usual, Unknowns(evidence.nominal)
        target = scene_at(scene, belief_from(evidence, usual, free))
        change = np.abs(differences(nominal, target) - differences(nominal, scene))
        limit = self.config.settled * usual.sigmas(unknowns)
        return bool((change < limit)[unknowns.pose_size :].all())

    def _adjusted(self, scene: Scene, seen: Observations, free: Free, evidence: Evidence) -> Scene:
        """Adjust the window with lenses and clocks as now known, after all that was known before it."""
        before = belief_from(self._evidence, self.config.usual, free)
        scene = scene_at(scene, belief_from(evidence, self.config.usual, free))
        for loss in (Loss(0.5), self._loss):
            on_road = road_landmarks(scene, seen, self.window.road_tolerance_m)
            scene = adjust(scene, seen, on_road, before, loss, self.window.graph).scene
        return scene

    def _with(self, scene: Scene, seen: Observations, *, curved: bool = True) -> Evidence:
        on_road = road_landmarks(scene, seen, self.window.road_tolerance_m)
        found = window_information(scene, seen, on_road, self._loss, self.window.graph, curved=curved)
        return self._evidence.with_window(found, scene)

    def _accuse(self, evidence: Evidence, config: AccusationConfig) -> tuple[Finding, ...]:
        return accusations(evidence.posterior(self.config.usual), evidence.nominal, config)

    def _as_told(self, finding: Finding) -> Finding:
        """Return the finding; what is corrected spoils no pose."""
        is_lens = finding.kind is FindingKind.WRONG_INTRINSICS
        if not (self._refines_lenses if is_lens else self._refines_clocks):
            return finding
        return replace(finding, about=f"{finding.about}; corrected", doubtful=False)

    def _free(self, evidence: Evidence) -> Free:
        """Return what may differ from the rig file: lenses to be refined, and what is under suspicion.

        Lenses all differ a little. Clocks are in step or they are not, so none is free without suspicion.
        """
        suspicious = self.config.accuse.model_copy(update={"sigmas": self.config.suspect_sigmas})
        lenses, clocks = set[str](), set[str]()
        for finding in self._accuse(evidence, suspicious):
            (lenses if finding.kind is FindingKind.WRONG_INTRINSICS else clocks).update(finding.cameras)
        asked = evidence.nominal.cameras if self._refines_lenses else lenses
        return Free(frozenset(asked), frozenset(clocks))
