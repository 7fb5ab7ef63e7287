"""The road as the car feels it: under every keyframe a plane of its own, on which the wheels stand.

Hills, humps and ramps bend the road by centimetres over a window; one plane for all of it would take that for
scale. Each keyframe's plane is known from where the car stands, up to ride height and tilt, and goes on
smoothly into the next one's. What lies under the car is held to the plane nearest to it.
"""

from __future__ import annotations

from itertools import pairwise

import gtsam
import numpy as np

from estimator.corridor import nearest_keyframe
from estimator.factors import GraphConfig, flattened, landmark_key, pose_key, to_gtsam
from estimator.observations import Mask, Observations
from estimator.scene import Scene
from estimator.stance import acceleration_mps2

_FAR_M = 1000.0
_ORTHOGRAPHIC = gtsam.Cal3_S2(_FAR_M, _FAR_M, 0.0, 0.0, 0.0)
# A camera far to the left of the car, level, sees the road edge on: its v is how far a point lies below it.
_ROAD_FROM_SIDE = gtsam.Pose3(
    gtsam.Rot3(np.array([[-1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, -1.0, 0.0]])), np.array([0.0, _FAR_M, 0.0])
)


def road_key(keyframe: int) -> int:
    return int(gtsam.symbol("r", keyframe))


def add_road(
    graph: gtsam.NonlinearFactorGraph,
    values: gtsam.Values,
    scene: Scene,
    observations: Observations,
    on_road: Mask,
    config: GraphConfig,
) -> None:
    """Add a plane a keyframe, what holds it to the car and to the next, and the landmarks on it."""
    _add_planes(graph, values, scene, config)
    seen = np.unique(observations.landmark)
    lying = seen[on_road[seen]]
    flat = _robust(np.array([1e3, config.road_sigma_m]))
    for landmark, keyframe in zip(lying, nearest_keyframe(scene, scene.points_world[lying]), strict=True):
        graph.add(
            gtsam.GenericProjectionFactorCal3_S2(
                np.zeros(2), flat, road_key(keyframe), landmark_key(landmark), _ORTHOGRAPHIC, _ROAD_FROM_SIDE
            )
        )


def _add_planes(
    graph: gtsam.NonlinearFactorGraph, values: gtsam.Values, scene: Scene, config: GraphConfig
) -> None:
    accelerations_mps2 = acceleration_mps2(scene.world_from_egos, scene.stamps_ns)
    for index, (pose, sprung) in enumerate(zip(scene.world_from_egos, accelerations_mps2, strict=True)):
        covariance = config.stance.covariance(sprung, scene.corridor.middle_m)
        stance = gtsam.noiseModel.Gaussian.Covariance(covariance)
        values.insert(road_key(index), to_gtsam(pose))
        graph.add(gtsam.BetweenFactorPose3(pose_key(index), road_key(index), gtsam.Pose3(), stance))
    for index, (before, after) in enumerate(pairwise(scene.world_from_egos)):
        step = flattened(before.inverse() @ after)
        length_m = max(float(np.linalg.norm(step.translation)), 0.1)
        bend = config.road_bend_per_m * length_m
        sigmas = np.array([bend, bend, 1e3, 1e3, 1e3, 0.5 * bend * length_m])
        graph.add(
            gtsam.BetweenFactorPose3(road_key(index), road_key(index + 1), to_gtsam(step), _robust(sigmas))
        )


def _robust(sigmas: np.ndarray) -> gtsam.noiseModel.Base:
    return gtsam.noiseModel.Robust.Create(
        gtsam.noiseModel.mEstimator.Cauchy.Create(1.0), gtsam.noiseModel.Diagonal.Sigmas(sigmas)
    )
