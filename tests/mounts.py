"""Small rigs, paths and errors of mounting, for tests that need no recording."""

from __future__ import annotations

import numpy as np

from estimator.camera import Camera
from estimator.rig import MountedCamera, Rig, RigPrior
from estimator.se3 import SE3, Array

PINHOLE = Camera("pinhole", (320, 200), (180.0, 180.0), (159.5, 99.5))
BROWN = Camera("brown_conrady", (320, 200), (180.0, 181.0), (161.0, 98.0), (-0.2, 0.05, 1e-3, -8e-4, -0.005))
FISHEYE = Camera("kannala_brandt", (320, 200), (110.0, 111.0), (158.5, 100.5), (0.02, -0.01, 0.003, -5e-4))


def mounted(
    camera: Camera, at_m: tuple[float, float, float], yaw_deg: float, pitch_deg: float
) -> MountedCamera:
    """Mount a camera looking ``yaw_deg`` to the left of ahead and ``pitch_deg`` below the horizon."""
    yaw, pitch = np.deg2rad([yaw_deg, pitch_deg])
    ahead = np.array([np.cos(yaw) * np.cos(pitch), np.sin(yaw) * np.cos(pitch), -np.sin(pitch)])
    right = np.array([np.sin(yaw), -np.cos(yaw), 0.0])
    rotation = np.column_stack([right, np.cross(ahead, right), ahead])
    return MountedCamera(camera, SE3(rotation, np.array(at_m)))


def left_side_rig(front: Camera = PINHOLE, left_front: Camera = PINHOLE, left_rear: Camera = PINHOLE) -> Rig:
    """Return a rig whose first two cameras share view and whose third sees later what the second saw."""
    return Rig(
        "front",
        {
            "front": mounted(front, (1.7, 0.1, 1.4), 0.0, 8.0),
            "left_front": mounted(left_front, (1.2, 0.9, 1.2), 55.0, 12.0),
            "left_rear": mounted(left_rear, (0.4, 0.9, 1.2), 138.0, 12.0),
        },
        RigPrior(2.0, 60.0),
    )


def arc(step_m: float, count: int, curvature_per_m: float = 1 / 70) -> tuple[SE3, ...]:
    """Return the poses of a car on a circle that starts at the origin, heading along x."""
    turn_rad = step_m * curvature_per_m
    step = SE3.exp(np.array([0.0, 0.0, turn_rad, step_m, 0.0, 0.0]))
    poses = [SE3()]
    for _ in range(count - 1):
        poses.append(poses[-1] @ step)
    return tuple(poses)


def shaken(rig: Rig, rotation_deg: float, translation_mm: float, seed: int = 0) -> Rig:
    """Return the rig with every camera but the reference turned and moved by exactly so much."""
    rng = np.random.default_rng(seed)
    moved = {}
    for name in rig.estimated_names:
        turn, shift = (each / np.linalg.norm(each) for each in rng.standard_normal((2, 3)))
        error = np.concatenate([turn * np.deg2rad(rotation_deg), shift * translation_mm / 1000])
        moved[name] = rig[name].ego_from_cam.retract(error)
    return rig.with_extrinsics(moved)


def worst_error(rig: Rig, truth: Rig) -> Array:
    """Return (2,) the largest rotation in deg and translation in mm between the cameras of two rigs."""
    errors = [truth[name].ego_from_cam.local(rig[name].ego_from_cam) for name in truth.cameras]
    return np.array(
        [
            np.rad2deg(max(np.linalg.norm(error[:3]) for error in errors)),
            1000 * max(np.linalg.norm(error[3:]) for error in errors),
        ]
    )
