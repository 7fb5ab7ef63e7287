"""Put a window's scene on the road: at its scale, level, the road at z = 0."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.corridor import in_corridor, road_height_m, road_landmarks
from estimator.factors import GraphConfig
from estimator.observations import Mask, Observations
from estimator.road import MIN_SLOPE, MIN_SUPPORT, densest_scale, road_scale
from estimator.scene import Scene
from estimator.se3 import SE3, Array

_FINE_BANDWIDTH = 0.012


def level_on_road(
    scene: Scene, reference: Observations, beliefs: GraphConfig, prior_sigma: float = np.inf
) -> tuple[Scene, Mask] | None:
    """Scale and tilt a scene so that the road is the plane z = 0 under a car of known camera height.

    The road is found by its height below the reference camera, each point judged in the frame of the car
    when it last saw it, so that drift and pitch do not add up over the window. The plane is fitted with the
    car's own stance as the prior: the strip of road in view is too narrow to give roll by itself.

    Args:
        scene: Poses and landmarks at any scale.
        reference: Sightings by the reference camera.
        beliefs: How the car stands on the road.
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
    in_path = in_corridor(scene, points)
    scale = road_scale(points_level, in_path, camera_height_m, prior_sigma)
    if scale is None:
        return None
    slope = -points_level[:, 2] / np.maximum(np.hypot(points_level[:, 0], points_level[:, 1]), 1e-9)
    height = points_level[:, 2] * scale + camera_height_m
    near = np.isfinite(height) & (slope > MIN_SLOPE) & (np.abs(height) < 0.1) & in_path
    scaled = _transformed(scene, SE3(), scale)
    world_from_road = _fit_plane(scaled, scaled.points_world[landmark[near]], beliefs)
    levelled = _transformed(scaled, world_from_road.inverse(), 1.0)
    on_road = np.zeros(len(scene.points_world), bool)
    on_road[landmark[near]] = np.abs(road_height_m(levelled, levelled.points_world[landmark[near]])) < 0.08
    return levelled, on_road


def rescale_on_road(scene: Scene, observations: Observations, prior_sigma: float) -> Scene:
    """Scale a scene that is level already, its rig too, by the road that all its cameras see from near.

    The first scale came from the reference camera's tracks alone and may be off by some percent, beyond
    where the adjustment's robust loss still feels the road. Where too little road is seen nothing changes.

    Args:
        scene: A level scene with its landmarks.
        observations: The sightings of all cameras.
        prior_sigma: Relative standard deviation of the scale the scene already has.
    """
    near = road_landmarks(scene, observations, 0.2)
    if near.sum() < MIN_SUPPORT:
        return scene
    reference = scene.rig[scene.rig.reference].ego_from_cam
    camera_height_m = float(reference.translation[2])
    depth = camera_height_m - road_height_m(scene, scene.points_world[near])
    scale = densest_scale(depth, np.ones(len(depth)), camera_height_m, _FINE_BANDWIDTH, prior_sigma)
    if scale is None:
        return scene
    larger = {}
    for name in scene.rig.estimated_names:
        pose = scene.rig[name].ego_from_cam
        larger[name] = SE3(
            pose.rotation, reference.translation + scale * (pose.translation - reference.translation)
        )
    scaled = _transformed(scene, SE3(), scale)
    rise = SE3(np.eye(3), np.array([0.0, 0.0, camera_height_m - _mean_height_m(scaled)]))
    settled = _transformed(scaled, rise, 1.0)
    return replace(settled, rig=scene.rig.with_extrinsics(larger))


def _mean_height_m(scene: Scene) -> float:
    """Return the mean height of the reference camera over the window."""
    reference = scene.rig[scene.rig.reference].ego_from_cam
    return float(np.mean([(pose @ reference).translation[2] for pose in scene.world_from_egos]))


def _fit_plane(scene: Scene, points: Array, beliefs: GraphConfig) -> SE3:
    """Return the pose of the road: z along its normal, under the first pose of the car, heading kept."""
    first = scene.world_from_egos[0]
    local = first.inverse().apply(points)
    stance = [first.inverse() @ pose for pose in scene.world_from_egos]
    ups = np.mean([pose.rotation[:, 2] for pose in stance], axis=0)
    height = float(np.mean([pose.translation[2] for pose in stance]))
    middle = np.mean([pose.translation[:2] for pose in stance], axis=0)
    design = np.column_stack([np.ones(len(local)), local[:, :2] - middle])
    prior_mean = np.array([height, -ups[0] / ups[2], -ups[1] / ups[2]])
    tilt_rad = beliefs.stance.tilt_sigma_rad
    prior = np.diag([1 / beliefs.stance.height_sigma_m**2, 1 / tilt_rad**2, 1 / tilt_rad**2])
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
