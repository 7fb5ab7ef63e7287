"""Adjust a window's scene loss by loss, each time with the road that the scene shows by then."""

from __future__ import annotations

from collections.abc import Sequence

from estimator.belief import Belief
from estimator.corridor import road_landmarks
from estimator.graph import Adjusted, adjust
from estimator.loss import Loss
from estimator.observations import Observations
from estimator.scene import Scene
from estimator.window_config import WindowConfig


def adjust_by_losses(
    scene: Scene,
    seen: Observations,
    belief: Belief,
    losses: Sequence[Loss],
    config: WindowConfig,
    *,
    want_covariance: bool = False,
) -> Adjusted:
    """Return a scene adjusted to one loss after another, from the wide to the tight.

    Args:
        scene: Starting values.
        seen: What was seen.
        belief: What is known of the extrinsics so far.
        losses: At least one.
        config: Beliefs and limits of the window.
        want_covariance: Also work out the posterior of the extrinsics under the last loss.

    Raises:
        RuntimeError: The system could not be solved.
    """
    for number, loss in enumerate(losses, start=1):
        on_road = road_landmarks(scene, seen, config.road_tolerance_m)
        wanted = want_covariance and number == len(losses)
        adjusted = adjust(scene, seen, on_road, belief, loss, config.graph, want_covariance=wanted)
        scene = adjusted.scene
    return adjusted
