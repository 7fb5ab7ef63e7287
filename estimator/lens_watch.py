"""Watch lenses and clocks while the car drives: gather every window's evidence, and correct where asked."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

import numpy as np

from estimator.belief import Belief
from estimator.camera import Camera
from estimator.clock_doubt import ClockDoubt, clock_doubt
from estimator.clock_or_shift import late_or_shifted
from estimator.clocks import Clocks
from estimator.corrections import belief_from
from estimator.evidence import Evidence, Free
from estimator.finding import Finding, FindingKind
from estimator.lens_config import LensConfig, Refine
from estimator.lens_findings import AccusationConfig, accusations
from estimator.lens_trial import LensTrial
from estimator.observations import Observations
from estimator.rig import Rig
from estimator.scene import Scene
from estimator.window_config import WindowConfig


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
            self._evidence = self._trial().settled(scene, seen)
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

    def _trial(self) -> LensTrial:
        return LensTrial(self._evidence, self._free, self.config, self.window)

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
