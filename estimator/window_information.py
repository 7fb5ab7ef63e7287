"""What a window's sightings say of extrinsics, lenses and clocks together, all else eliminated.

The same model as ``estimator.factors``, linearised in numpy, with columns for what the graph holds fixed.
Landmarks and poses are eliminated by Schur complements. What was believed before is left out, so the
information of several windows may be added up.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from estimator.factors import GraphConfig, Loss, levelled
from estimator.observations import Mask, Observations
from estimator.scene import Scene
from estimator.se3 import Array
from estimator.sighting_jacobians import SightingJacobians, body_twists, sighting_jacobians
from estimator.unknowns import Unknowns

_FAR = 20.0  # as in factors.add_landmarks


@dataclass(frozen=True, eq=False)
class WindowInformation:
    """A quadratic about the window's values: cost(d) = d^T hessian d / 2 + d^T gradient.

    Attributes:
        hessian: (D, D) over ``Unknowns``.
        scores: (L, D) each landmark's part of the gradient; they sum to it but for the factors on poses.
        gradient: (D,).
    """

    hessian: Array
    scores: Array
    gradient: Array


def window_information(
    scene: Scene,
    seen: Observations,
    on_road: Mask,
    stamps_ns: Sequence[int],
    loss: Loss,
    config: GraphConfig,
) -> WindowInformation:
    """Linearise a window at its adjusted values and eliminate landmarks and poses.

    Args:
        scene: Adjusted values.
        seen: The sightings they were adjusted to.
        on_road: (M,) landmarks believed to lie on the road.
        stamps_ns: Stamp of each keyframe.
        loss: Robust loss; each sighting counts with the weight it has at these values.
        config: What else the adjustment believed.
    """
    jacobians = sighting_jacobians(scene, seen, body_twists(scene.world_from_egos, stamps_ns))
    usable = np.asarray(np.isfinite(jacobians.by_extrinsics).all((1, 2)))
    seen, jacobians = seen.select(usable), jacobians.select(usable)
    unknowns = Unknowns(scene.rig)
    rows = _rows(jacobians, seen, unknowns, len(scene.world_from_egos))
    error = jacobians.residual_px
    weight = 1 / (1 + (error**2).sum(1) / loss.scale_px**2) / seen.sigma_px**2
    hessian, scores = _without_landmarks(scene, seen, on_road, rows, jacobians.by_point, error, weight, config)
    gradient = scores.sum(0)
    _add_poses(hessian, gradient, scene, config)
    size = unknowns.size
    gain = np.linalg.solve(hessian[size:, size:], hessian[size:, :size])
    return WindowInformation(
        hessian[:size, :size] - hessian[:size, size:] @ gain,
        scores[:, :size] - scores[:, size:] @ gain,
        gradient[:size] - gradient[size:] @ gain,
    )


def _rows(jacobians: SightingJacobians, seen: Observations, unknowns: Unknowns, keyframes: int) -> Array:
    """Return (N, 2, D + 6 K) derivatives by the unknowns, then by the poses."""
    rows = np.zeros((len(seen), 2, unknowns.size + 6 * keyframes))
    for camera in range(len(unknowns.names)):
        mine = np.flatnonzero(seen.camera == camera)
        if unknowns.names[camera] in unknowns.estimated:
            rows[mine, :, unknowns.extrinsics(camera)] = jacobians.by_extrinsics[mine]
        rows[mine, :, unknowns.lens(camera)] = jacobians.by_lens[mine]
        rows[mine, :, unknowns.clock(camera)] = jacobians.by_clock[mine]
    for keyframe in range(keyframes):
        mine = np.flatnonzero(seen.keyframe == keyframe)
        first = unknowns.size + 6 * keyframe
        rows[mine, :, first : first + 6] = jacobians.by_pose[mine]
    return rows


def _without_landmarks(
    scene: Scene,
    seen: Observations,
    on_road: Mask,
    rows: Array,
    by_point: Array,
    error: Array,
    weight: Array,
    config: GraphConfig,
) -> tuple[Array, Array]:
    """Eliminate every landmark by itself: return the Hessian of the rest and the (L, .) parts of its gradient."""
    order = np.argsort(seen.landmark, kind="stable")
    landmark, start = np.unique(seen.landmark[order], return_index=True)
    rows, by_point, error = rows[order], by_point[order], error[order]
    weight = weight[order]
    weighted = by_point * weight[:, None, None]
    points = np.add.reduceat(weighted.transpose(0, 2, 1) @ by_point, start)
    pulls = np.add.reduceat(np.einsum("nri,nr->ni", weighted, error), start)
    cross = np.add.reduceat(rows.transpose(0, 2, 1) @ weighted, start)
    own = np.add.reduceat(np.einsum("nri,nr->ni", rows, error * weight[:, None]), start)
    _add_landmark_priors(points, pulls, scene.points_world[landmark], on_road[landmark], scene, config)
    gain = np.linalg.solve(points, cross.transpose(0, 2, 1))  # (L, 3, .)
    flat = (rows * np.sqrt(weight)[:, None, None]).reshape(-1, rows.shape[2])
    eliminated = cross.transpose(1, 0, 2).reshape(rows.shape[2], -1) @ gain.reshape(-1, rows.shape[2])
    return flat.T @ flat - eliminated, own - np.einsum("lid,li->ld", gain, pulls)


def _add_landmark_priors(
    points: Array, pulls: Array, at: Array, on_road: Mask, scene: Scene, config: GraphConfig
) -> None:
    centre = np.mean([p.translation for p in scene.world_from_egos], axis=0)
    far = _FAR * np.maximum(1.0, np.linalg.norm(at - centre, axis=1))
    points += np.eye(3) / far[:, None, None] ** 2
    height = at[:, 2] / config.road_sigma_m
    weight = np.where(on_road, 1 / (1 + height**2) / config.road_sigma_m**2, 0.0)
    points[:, 2, 2] += weight
    pulls[:, 2] += weight * at[:, 2]


def _add_poses(hessian: Array, gradient: Array, scene: Scene, config: GraphConfig) -> None:
    tilt, height = config.ride_tilt_sigma_rad, config.ride_height_sigma_m
    first = len(hessian) - 6 * len(scene.world_from_egos)
    for index, pose in enumerate(scene.world_from_egos):
        sigma = np.array([tilt, tilt, 1e3, 1e3, 1e3, height])
        if index == 0:
            sigma = np.array([tilt, tilt, 1e-5, 1e-4, 1e-4, height])
        block = slice(first + 6 * index, first + 6 * index + 6)
        hessian[block, block] += np.diag(sigma**-2)
        gradient[block] += levelled(pose).local(pose) / sigma**2
