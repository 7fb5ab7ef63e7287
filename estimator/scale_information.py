"""How much each source of a window's graph says of scale.

Images say nothing when path, landmarks and mounting positions all grow alike. So the information on scale is
what the other factors resist such growth with, after the road's planes and the axle's slip have given way as
suits them best.
"""

from __future__ import annotations

from collections.abc import Mapping

import gtsam
import numpy as np

from estimator.factors import camera_key, estimated, landmark_key, pose_key, slip_key
from estimator.road_planes import road_key
from estimator.scale import ScaleInformation
from estimator.scene import Scene
from estimator.se3 import Array


def scale_information(
    sources: Mapping[str, gtsam.NonlinearFactorGraph], values: gtsam.Values, scene: Scene
) -> ScaleInformation:
    """Return the information on the logarithm of scale by source.

    Args:
        sources: The factors of each source; none that comes from images.
        values: Where the graph has its minimum.
        scene: The same values; landmarks that the sources do not touch may be unknown.
    """
    growth = _growth(scene)
    resistance = {name: _resistance(graph, values, growth) for name, graph in sources.items()}
    total = np.sum(list(resistance.values()), axis=0)
    yielding = np.linalg.lstsq(total[1:, 1:], -total[1:, 0])[0]
    whole = np.concatenate([[1.0], yielding])
    return {name: float(whole @ matrix @ whole) for name, matrix in resistance.items()}


def _growth(scene: Scene) -> dict[int, Array]:
    """Return by key how a variable moves as the scene grows (column 0) and as what may yield does (others).

    The scene grows about the world's origin, and the rig about its reference camera.
    """
    poses, count = scene.world_from_egos, len(scene.world_from_egos)
    mount = scene.rig[scene.rig.reference].ego_from_cam.translation
    width = 1 + 6 * count + 2
    growth = {}
    for index, pose in enumerate(poses):
        growth[pose_key(index)] = _column(
            np.concatenate([np.zeros(3), pose.inverse().rotation @ pose.apply(mount)]), width
        )
        growth[road_key(index)] = np.eye(width)[1 + 6 * index : 7 + 6 * index]
    for index, name in estimated(scene):
        mounting = scene.rig[name].ego_from_cam
        away_cam = mounting.rotation.T @ (mounting.translation - mount)
        growth[camera_key(index)] = _column(np.concatenate([np.zeros(3), away_cam]), width)
    for index, point in enumerate(scene.points_world):
        growth[landmark_key(index)] = _column(point, width)
    growth[slip_key()] = np.eye(width)[-2:]
    return growth


def _column(first: Array, width: int) -> Array:
    return np.hstack([first[:, None], np.zeros((len(first), width - 1))])


def _resistance(
    graph: gtsam.NonlinearFactorGraph, values: gtsam.Values, growth: Mapping[int, Array]
) -> Array:
    """Return (W, W) the information of a source on the ways the scene may grow and yield."""
    linear = graph.linearize(values)
    order = gtsam.Ordering()
    keys = list(linear.keyVector())
    for key in keys:
        order.push_back(key)
    if not keys:
        width = next(iter(growth.values())).shape[1]
        return np.zeros((width, width))
    resisted = linear.jacobian(order)[0] @ np.vstack([growth[key] for key in keys])
    return np.asarray(resisted.T @ resisted)
