"""Metric scale and level from the road: the reference camera's height above it is known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.observations import Mask, Observations
from estimator.scene import Scene
from estimator.se3 import SE3, Array

_MIN_SUPPORT = 12
_BANDWIDTH = 0.03  # of log height
_MIN_SLOPE = 0.1  # nearer than about ten camera heights: beyond, half a degree of pitch moves the road
_TILT_SIGMA_RAD = 0.01
_HEIGHT_SIGMA_M = 0.02


def road_scale(points_level: Array, camera_height_m: float, prior_sigma: float = np.inf) -> float | None:
    """Return the factor that puts the road at z = 0 below a camera of known height.

    The road is the densest level among the points below the camera: facades spread over all heights, the
    road does not. Assumes points within reach of the camera's own road patch and a known up direction.

    Args:
        points_level: (N, 3) in a gravity-aligned frame centred in the camera (x forward, z up), any unit.
        camera_height_m: Height of the camera above the road.
        prior_sigma: Relative standard deviation with which the unit is already believed to be the metre.

    Returns:
        Metres per unit, or None where too few points agree.
    """
    depth = -points_level[:, 2]
    reach = np.hypot(points_level[:, 0], points_level[:, 1])
    slope = depth / np.maximum(reach, 1e-9)
    below = np.isfinite(depth) & (depth > 0) & (slope > _MIN_SLOPE)
    if below.sum() < _MIN_SUPPORT:
        return None
    level = np.log(depth[below])
    weight = np.minimum(slope[below], 0.5)
    grid = np.arange(level.min() - 0.1, level.max() + 0.1, _BANDWIDTH / 3)
    distance = (grid[:, None] - level[None]) / _BANDWIDTH
    kernel = np.exp(-0.5 * distance**2)
    surprise = (grid - np.log(camera_height_m)) / max(prior_sigma, 1e-6)
    density = (kernel @ weight) * np.exp(-0.5 * surprise**2)
    best = int(density.argmax())
    near = np.abs(distance[best]) < 2
    if near.sum() < _MIN_SUPPORT:
        return None
    return float(camera_height_m / np.exp(np.median(level[near])))


def level_on_road(
    scene: Scene, reference: Observations, prior_sigma: float = np.inf
) -> tuple[Scene, Mask] | None:
    """Scale and tilt a scene so that the road is the plane z = 0 under a car of known camera height.

    The road is found by its height below the reference camera, each point judged in the frame of the car
    when it last saw it, so that drift and pitch do not add up over the window. The plane is fitted with the
    car's own stance as the prior: the strip of road in view is too narrow to give roll by itself.

    Args:
        scene: Poses and landmarks at any scale.
        reference: Sightings by the reference camera.
        prior_sigma: Relative standard deviation of the scale the scene already has.

    Returns:
        The scene, its first pose at x = y = 0, and (M,) which landmarks are road; None without a road.
    """
    camera_height_m = float(scene.rig[scene.rig.reference].ego_from_cam.translation[2])
    order = np.lexsort((reference.keyframe, reference.landmark))
    landmark, start, count = np.unique(reference.landmark[order], return_index=True, return_counts=True)
    last = reference.select(order[start + count - 1])
    points = scene.points_world[landmark]
    rotation = np.stack([p.rotation for p in scene.world_from_egos])[last.keyframe]
    _, center = scene.pose_arrays(last.camera, last.keyframe)
    points_level = np.einsum("nji,nj->ni", rotation, points - center)
    scale = road_scale(points_level, camera_height_m, prior_sigma)
    if scale is None:
        return None
    slope = -points_level[:, 2] / np.maximum(np.hypot(points_level[:, 0], points_level[:, 1]), 1e-9)
    height = points_level[:, 2] * scale + camera_height_m
    near = np.isfinite(height) & (slope > _MIN_SLOPE) & (np.abs(height) < 0.15)
    scaled = _transformed(scene, SE3(), scale)
    world_from_road = _fit_plane(scaled, scaled.points_world[landmark[near]])
    levelled = _transformed(scaled, world_from_road.inverse(), 1.0)
    on_road = np.zeros(len(scene.points_world), bool)
    on_road[landmark[near]] = np.abs(levelled.points_world[landmark[near], 2]) < 0.08
    return levelled, on_road


def _fit_plane(scene: Scene, points: Array) -> SE3:
    """Return the pose of the road: z along its normal, under the first pose of the car, heading kept."""
    first = scene.world_from_egos[0]
    local = first.inverse().apply(points)
    stance = [first.inverse() @ pose for pose in scene.world_from_egos]
    ups = np.mean([pose.rotation[:, 2] for pose in stance], axis=0)
    height = float(np.mean([pose.translation[2] for pose in stance]))
    middle = np.mean([pose.translation[:2] for pose in stance], axis=0)
    design = np.column_stack([np.ones(len(local)), local[:, :2] - middle])
    prior_mean = np.array([height, -ups[0] / ups[2], -ups[1] / ups[2]])
    prior = np.diag([1 / _HEIGHT_SIGMA_M**2, 1 / _TILT_SIGMA_RAD**2, 1 / _TILT_SIGMA_RAD**2])
    plane = prior_mean
    for _ in range(10):
        error = local[:, 2] - design @ plane
        weight = 1 / (0.02**2 * (1 + (error / 0.03) ** 2)) / max(1.0, len(local) / 50)
        hessian = design.T @ (design * weight[:, None]) + prior
        plane = np.linalg.solve(hessian, design.T @ (weight * local[:, 2]) + prior @ prior_mean)
    normal = np.array([-plane[1], -plane[2], 1.0]) / np.linalg.norm([plane[1], plane[2], 1.0])
    ahead = np.array([1.0, 0.0, plane[1]])
    ahead -= normal * (normal @ ahead)
    ahead /= np.linalg.norm(ahead)
    under_first = np.array([0.0, 0.0, plane[0] - plane[1:] @ middle])
    first_from_road = SE3(np.column_stack([ahead, np.cross(normal, ahead), normal]), under_first)
    return first @ first_from_road


def _transformed(scene: Scene, new_from_old: SE3, scale: float) -> Scene:
    """Move and scale the world; the rig keeps its size, so the cars' paths scale about the first camera."""
    reference = scene.rig[scene.rig.reference].ego_from_cam
    origin = (scene.world_from_egos[0] @ reference).translation
    poses = []
    for pose in scene.world_from_egos:
        camera = pose @ reference
        moved = SE3(camera.rotation, origin + scale * (camera.translation - origin))
        poses.append(new_from_old @ moved @ reference.inverse())
    points = new_from_old.apply(origin + scale * (scene.points_world - origin))
    return replace(scene, world_from_egos=tuple(poses), points_world=points)


def road_landmarks(
    scene: Scene, observations: Observations, tolerance_m: float, min_slope: float = 0.3
) -> Mask:
    """Return (M,) the landmarks that lie on the road and were seen from near enough to tell."""
    points = scene.points_world[observations.landmark]
    _, center = scene.pose_arrays(observations.camera, observations.keyframe)
    down = center - points
    slope = down[:, 2] / np.maximum(np.hypot(down[:, 0], down[:, 1]), 1e-9)
    steepest = np.full(len(scene.points_world), -np.inf)
    np.maximum.at(steepest, observations.landmark, np.nan_to_num(slope, nan=-np.inf))
    with np.errstate(invalid="ignore"):
        return np.asarray((np.abs(scene.points_world[:, 2]) < tolerance_m) & (steepest > min_slope))
