"""What the sightings of a landmark say of where it is, and which leave its depth open."""

from __future__ import annotations

import numpy as np

from estimator.loss import Loss
from estimator.observations import Mask, Observations
from estimator.scene import Scene
from estimator.se3 import Array

# Of the information in the weakest direction over that in the strongest: a parallax of about a milliradian.
# GTSAM takes a landmark below 2^-24 for indeterminate.
_LEAST_RATIO = 1e-6


def landmark_information(scene: Scene, observations: Observations, loss: Loss) -> Array:
    """Return (M, 3, 3) information on landmarks in 1/m^2, poses and cameras taken as known; zero if unseen.

    A ray says where a landmark is across itself, as well as its angle is known at that distance; sightings
    that do not fit have as little say as the loss leaves them.
    """
    points = scene.points_world[observations.landmark]
    _, center = scene.pose_arrays(observations.camera, observations.keyframe)
    distance_m = np.maximum(np.linalg.norm(points - center, axis=1), 0.01)
    ray = (points - center) / distance_m[:, None]
    focal_px = np.array([np.mean(m.camera.focal_px) for m in scene.rig.cameras.values()])
    across = focal_px[observations.camera] / (distance_m * observations.sigma_px)
    weight = across**2 * loss.weights(scene.residuals_px(observations), observations.sigma_px)
    information = np.zeros((len(scene.points_world), 3, 3))
    each = weight[:, None, None] * (np.eye(3) - ray[:, :, None] * ray[:, None, :])
    np.add.at(information, observations.landmark, np.nan_to_num(each))
    return information


def indeterminate_landmarks(scene: Scene, observations: Observations, loss: Loss) -> Mask:
    """Tell which (M,) landmarks have sightings that together leave their depth open."""
    eigenvalues = np.linalg.eigvalsh(landmark_information(scene, observations, loss))
    return np.asarray((eigenvalues[:, 2] > 0) & (eigenvalues[:, 0] < _LEAST_RATIO * eigenvalues[:, 2]))
