"""Adjust a window once more, after another belief than the one it was solved with."""

from __future__ import annotations

from dataclasses import replace

from estimator.belief import Belief
from estimator.corridor import road_landmarks
from estimator.graph import adjust
from estimator.loss import Loss
from estimator.window_config import WindowConfig
from estimator.window_result import WindowResult, conclude

_LOSS_PX = 1.0  # wide enough for what a belief that does not hold has kept away


def adjust_again(result: WindowResult, belief: Belief, config: WindowConfig) -> WindowResult | None:
    """Return what the window teaches after ``belief``; None if too little of it agrees then.

    Raises:
        RuntimeError: The system could not be solved.
    """
    scene, seen = result.scene, result.seen
    on_road = road_landmarks(scene, seen, config.road_tolerance_m)
    scene = adjust(scene, seen, on_road, belief, Loss(_LOSS_PX), config.graph).scene
    on_road = road_landmarks(scene, seen, config.road_tolerance_m)
    loss = Loss(config.sighting_noise.loss_sigmas, of_sigma=True)
    adjusted = adjust(scene, seen, on_road, belief, loss, config.graph, want_covariance=True)
    again = conclude(adjusted.scene, seen, adjusted.covariance, result.track_sightings, config.result)
    return again and replace(again, scale_information=adjusted.scale_information)
