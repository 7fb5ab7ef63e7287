"""What a window's sightings say of extrinsics, lenses and clocks together, all else eliminated.

The same model as ``estimator.graph``, with columns for what the graph holds fixed. Landmarks and poses are
eliminated by Schur complements. What was believed of the extrinsics before is left out, so the information
of several windows may be added up.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.factors import GraphConfig
from estimator.graph_rows import belief_rows
from estimator.loss import Loss
from estimator.observations import Mask, Observations
from estimator.rows import Rows
from estimator.scene import Scene
from estimator.se3 import Array
from estimator.sighting_jacobians import sighting_jacobians
from estimator.unknowns import Unknowns


@dataclass(frozen=True, eq=False)
class WindowInformation:
    """A quadratic about the window's values: cost(d) = d^T hessian d / 2 + d^T gradient.

    Attributes:
        hessian: (D, D) over ``Unknowns``.
        gradient: (D,).
        scores: (L, D) each landmark's part of the gradient.
    """

    hessian: Array
    gradient: Array
    scores: Array


def window_information(
    scene: Scene,
    seen: Observations,
    on_road: Mask,
    loss: Loss,
    config: GraphConfig,
    *,
    curved: bool = False,
) -> WindowInformation:
    """Linearise a window at its adjusted values and eliminate landmarks and poses.

    A Cauchy loss gives a sighting the weight w = 1 / (1 + r^2 / scale^2). The solver's Hessian holds w; it
    steps safely, but states more than is known, because the loss bends less than that: on average over
    directions by w^2.

    Args:
        scene: Adjusted values, with clocks.
        seen: The sightings they were adjusted to.
        on_road: (M,) landmarks believed to lie on the road.
        loss: Robust loss; each sighting counts with the weight it has at these values.
        config: What else the adjustment believed.
        curved: Take the loss's own curvature instead of the solver's Hessian.
    """
    unknowns = Unknowns(scene.rig)
    beliefs = belief_rows(scene, seen, on_road, config, unknowns.size)
    rows = Rows.stacked([_sighting_rows(scene, seen, loss, unknowns, curved), beliefs])
    hessian, gradient, scores = rows.without_landmarks()
    size = unknowns.size
    gain = np.linalg.solve(hessian[size:, size:], hessian[size:, :size])
    return WindowInformation(
        hessian[:size, :size] - hessian[:size, size:] @ gain,
        gradient[:size] - gradient[size:] @ gain,
        scores[:, :size] - scores[:, size:] @ gain,
    )


def _sighting_rows(scene: Scene, seen: Observations, loss: Loss, unknowns: Unknowns, curved: bool) -> Rows:
    """Return two rows a sighting, by the unknowns and then by the poses.

    With w the weight, rows times w and errors times one give the gradient of w and a Hessian of w^2.
    """
    jacobians = sighting_jacobians(scene, seen)
    usable = np.asarray(np.isfinite(jacobians.by_extrinsics).all((1, 2)))
    seen, jacobians = seen.select(usable), jacobians.select(usable)
    rest = np.zeros((len(seen), 2, unknowns.size + 6 * len(scene.world_from_egos)))
    for camera, name in enumerate(unknowns.names):
        mine = np.flatnonzero(seen.camera == camera)
        if name in unknowns.estimated:
            rest[mine, :, unknowns.extrinsics(camera)] = jacobians.by_extrinsics[mine]
        rest[mine, :, unknowns.lens(camera)] = jacobians.by_lens[mine]
        rest[mine, :, unknowns.clock(camera)] = jacobians.by_clock[mine]
    for keyframe in range(len(scene.world_from_egos)):
        mine = np.flatnonzero(seen.keyframe == keyframe)
        first = unknowns.size + 6 * keyframe
        rest[mine, :, first : first + 6] = jacobians.by_pose[mine]
    error = jacobians.residual_px
    weight = loss.weights(np.linalg.norm(error, axis=1), seen.sigma_px)
    scale = (weight if curved else np.sqrt(weight)) / seen.sigma_px
    pull = (np.ones_like(weight) if curved else np.sqrt(weight)) / seen.sigma_px
    return Rows(
        np.repeat(seen.landmark, 2),
        (rest * scale[:, None, None]).reshape(2 * len(seen), -1),
        (jacobians.by_point * scale[:, None, None]).reshape(-1, 3),
        (error * pull[:, None]).ravel(),
    )
