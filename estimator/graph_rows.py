"""The rows of a graph's factors on poses and landmarks, but for the sightings: taken from GTSAM itself.

So what is believed of road, ride height and gauge is written once, in ``estimator.factors``.
"""

from __future__ import annotations

import gtsam
import numpy as np

from estimator.factors import GraphConfig, add_kinematics, add_landmarks, add_poses, pose_key
from estimator.observations import Mask, Observations
from estimator.road_planes import add_road
from estimator.rows import NO_LANDMARK, Rows
from estimator.scene import Scene


def belief_rows(
    scene: Scene, seen: Observations, on_road: Mask, config: GraphConfig, first_pose: int
) -> Rows:
    """Linearise all that a window believes besides sightings and extrinsics.

    Args:
        scene: Present values.
        seen: The sightings; their landmarks are those of the graph.
        on_road: (M,) landmarks believed to lie on the road.
        config: Beliefs.
        first_pose: Column of the first pose; the poses follow each other, and after them comes whatever
            else the factors depend on.
    """
    graph, values = gtsam.NonlinearFactorGraph(), gtsam.Values()
    add_poses(graph, values, scene, config, False)
    determinate = np.zeros(len(scene.points_world), bool)  # priors on the others are no evidence either
    add_landmarks(graph, values, scene, seen, determinate)
    add_road(graph, values, scene, seen, on_road, config)
    add_kinematics(graph, values, scene, config)
    linear = graph.linearize(values)
    factors = [linear.at(index) for index in range(linear.size())]
    poses = [pose_key(keyframe) for keyframe in range(len(scene.world_from_egos))]
    concerned = set().union(*(factor.keys() for factor in factors))
    others = sorted(key for key in concerned.difference(poses) if not _is_landmark(key))
    columns, width = {}, first_pose
    for key in (*poses, *others):
        size = _size(values, key)
        columns[key] = slice(width, width + size)
        width += size
    return Rows.stacked([_rows_of(factor, columns, width) for factor in factors])


def _size(values: gtsam.Values, key: int) -> int:
    """Return how many unknowns a pose, or a vector of them, has."""
    try:
        return len(values.atVector(key))
    except RuntimeError:
        return 6


def _rows_of(factor: gtsam.GaussianFactor, columns: dict[int, slice], width: int) -> Rows:
    matrix, target = factor.jacobian()
    landmark, point, rest = NO_LANDMARK, np.zeros((len(target), 3)), np.zeros((len(target), width))
    first, keys = 0, factor.keys()
    for key in keys:
        if _is_landmark(key):
            landmark, point = gtsam.symbolIndex(key), matrix[:, first : first + 3]
            first += 3
        else:
            size = columns[key].stop - columns[key].start
            rest[:, columns[key]] = matrix[:, first : first + size]
            first += size
    return Rows(np.full(len(target), landmark), rest, point, -target)


def _is_landmark(key: int) -> bool:
    return bool(gtsam.symbolChr(key) == ord("l"))
