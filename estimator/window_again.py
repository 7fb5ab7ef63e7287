"""Adjust a window once more, after another belief than the one it was solved with."""

from __future__ import annotations

from dataclasses import replace

from estimator.belief import Belief
from estimator.loss import Loss
from estimator.window_adjust import adjust_by_losses
from estimator.window_config import WindowConfig
from estimator.window_result import WindowResult, conclude

_WIDE = Loss(1.0)  # px, for what a belief that does not hold has kept away


def adjust_again(result: WindowResult, belief: Belief, config: WindowConfig) -> WindowResult | None:
    """Return what the window teaches after ``belief``; None if too little of it agrees then.

    Raises:
        RuntimeError: The system could not be solved.
    """
    losses = (_WIDE, config.sighting_noise.loss)
    adjusted = adjust_by_losses(result.scene, result.seen, belief, losses, config, want_covariance=True)
    again = conclude(adjusted.scene, result.seen, adjusted.covariance, result.track_sightings, config.result)
    return again and replace(again, scale_information=adjusted.scale_information)
