"""Adjust poses, extrinsics and landmarks of a window together, as a GTSAM factor graph."""

from __future__ import annotations

from dataclasses import dataclass, replace

import gtsam
import numpy as np

from estimator.belief import Belief
from estimator.factors import (
    GraphConfig,
    add_cameras,
    add_kinematics,
    add_landmarks,
    add_poses,
    add_sightings,
    camera_key,
    estimated,
    from_gtsam,
    landmark_key,
    pose_key,
)
from estimator.landmark_information import indeterminate_landmarks
from estimator.loss import Loss
from estimator.observations import Mask, Observations
from estimator.road_planes import add_road
from estimator.scale import BELIEF, REAR_AXLE, ROAD, ScaleInformation
from estimator.scale_information import scale_information
from estimator.scene import Scene
from estimator.se3 import Array


@dataclass(frozen=True, eq=False)
class Adjusted:
    """The outcome of an adjustment.

    Attributes:
        scene: The adjusted values.
        covariance: (6 C, 6 C) of the C estimated cameras' extrinsics in the rig's order, right perturbation
            of ``scene.rig``; empty if not asked for.
        scale_information: What each source says of scale; empty if no covariance was asked for.
    """

    scene: Scene
    covariance: Array
    scale_information: ScaleInformation


def adjust(
    scene: Scene,
    observations: Observations,
    on_road: Mask,
    belief: Belief,
    loss: Loss,
    config: GraphConfig,
    *,
    fixed_poses: bool = False,
    want_covariance: bool = False,
) -> Adjusted:
    """Minimise the robust reprojection error over a window.

    Args:
        scene: Starting values. Landmarks without a value must have no observation.
        observations: What was seen.
        on_road: (M,) landmarks believed to lie on the road, within a few centimetres.
        belief: What is known of the extrinsics so far: the prior.
        loss: Robust loss.
        config: Beliefs and limits.
        fixed_poses: Keep the car's poses where they are.
        want_covariance: Also work out the posterior of the extrinsics.

    Returns:
        The adjusted scene and the covariance.

    Raises:
        RuntimeError: The system could not be solved.
    """
    graph, values = gtsam.NonlinearFactorGraph(), gtsam.Values()
    indeterminate = indeterminate_landmarks(scene, observations, loss)
    observations = scene.as_if_in_time(observations)
    add_poses(graph, values, scene, config, fixed_poses)
    add_landmarks(graph, values, scene, observations, indeterminate)
    add_sightings(graph, scene, observations, loss)
    sources = {name: gtsam.NonlinearFactorGraph() for name in (ROAD, REAR_AXLE, BELIEF)}
    add_road(sources[ROAD], values, scene, observations, on_road, config)
    add_cameras(sources[BELIEF], values, scene, belief)
    if not fixed_poses:
        add_kinematics(sources[REAR_AXLE], values, scene, config)
    for source in sources.values():
        graph.push_back(source)
    parameters = gtsam.LevenbergMarquardtParams()
    parameters.setMaxIterations(config.iterations)
    parameters.setRelativeErrorTol(config.relative_tolerance)
    values = gtsam.LevenbergMarquardtOptimizer(graph, values, parameters).optimize()
    adjusted = _read_back(values, scene, observations)
    if not want_covariance:
        return Adjusted(adjusted, np.zeros((0, 0)), {})
    covariance = _covariance(graph, values, scene)
    return Adjusted(adjusted, covariance, scale_information(sources, values, adjusted))


def _covariance(graph: gtsam.NonlinearFactorGraph, values: gtsam.Values, scene: Scene) -> Array:
    """Marginalise everything but the extrinsics."""
    kept = [camera_key(index) for index, _ in estimated(scene)]
    linear = graph.linearize(values)
    poses = {pose_key(index) for index in range(len(scene.world_from_egos))}
    eliminated, order = gtsam.Ordering(), gtsam.Ordering()
    for key in linear.keyVector():
        if key not in poses and key not in kept:
            eliminated.push_back(key)
    for key in poses:
        eliminated.push_back(key)
    for key in kept:
        order.push_back(key)
    _, remaining = linear.eliminatePartialMultifrontal(eliminated)
    return np.asarray(np.linalg.inv(np.array(remaining.hessian(order)[0])))


def _read_back(values: gtsam.Values, scene: Scene, observations: Observations) -> Scene:
    poses = tuple(from_gtsam(values.atPose3(pose_key(k))) for k in range(len(scene.world_from_egos)))
    extrinsics = {
        name: from_gtsam(values.atPose3(camera_key(index)))
        for index, name in enumerate(scene.rig.cameras)
        if name != scene.rig.reference
    }
    points = np.full_like(scene.points_world, np.nan)
    for index in np.unique(observations.landmark):
        points[index] = values.atPoint3(landmark_key(index))
    return replace(
        scene, rig=scene.rig.with_extrinsics(extrinsics), world_from_egos=poses, points_world=points
    )
