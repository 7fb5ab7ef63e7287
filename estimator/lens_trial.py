"""Try a window with lenses and clocks as its evidence has them, until it no longer changes them.

A lens or clock that is far off makes the adjustment distrust the very sightings that show it, so one
linearisation misstates the error.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from estimator.corrections import belief_from, scene_at
from estimator.corridor import road_landmarks
from estimator.evidence import Evidence, Free, differences
from estimator.lens_config import LensConfig
from estimator.observations import Observations
from estimator.scene import Scene
from estimator.unknowns import Unknowns
from estimator.window_adjust import adjust_by_losses
from estimator.window_config import WindowConfig
from estimator.window_information import window_information


@dataclass(frozen=True)
class LensTrial:
    """One window's trial.

    Attributes:
        before: The evidence of all windows before it.
        free: What may differ from the rig file, by the evidence so far.
        config: What is usual, and when lenses and clocks have settled.
        window: How the window is adjusted.
    """

    before: Evidence
    free: Callable[[Evidence], Free]
    config: LensConfig
    window: WindowConfig

    def settled(self, scene: Scene, seen: Observations) -> Evidence:
        """Return all evidence, the window's at lenses and clocks that it no longer changes.

        Raises:
            RuntimeError: The window could not be adjusted.
        """
        evidence, free = self.before, self.free(self.before)
        if evidence.window_count and not self._is_settled(scene, free, evidence):
            scene = self._adjusted(scene, seen, free, evidence)
        evidence = self._with(scene, seen)
        for _ in range(self.config.rounds):
            free = self.free(evidence)
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
        before = belief_from(self.before, self.config.usual, free)
        scene = scene_at(scene, belief_from(evidence, self.config.usual, free))
        return adjust_by_losses(scene, seen, before, self.window.fine_losses, self.window).scene

    def _with(self, scene: Scene, seen: Observations, *, curved: bool = True) -> Evidence:
        on_road = road_landmarks(scene, seen, self.window.road_tolerance_m)
        loss, graph = self.window.sighting_noise.loss, self.window.graph
        found = window_information(scene, seen, on_road, loss, graph, curved=curved)
        return self.before.with_window(found, scene)
