"""The factors of a window's graph, one kind a function: poses, landmarks, sightings, extrinsics.

Measurements are moved to the undistorted normalised plane, with their covariance, so that one factor type
serves every lens; see ``Camera``. The reference camera's extrinsics are constants: that is the gauge.
"""

from __future__ import annotations

import gtsam
import gtsam_unstable
import numpy as np

from estimator.belief import Belief
from estimator.config import Config
from estimator.kinematics import RearAxleConfig, add_rear_axle
from estimator.loss import Loss
from estimator.observations import Mask, Observations
from estimator.ranges import PositiveShare, SigmaM, SigmaRad, StepCount
from estimator.scene import Scene
from estimator.se3 import SE3, Array
from estimator.stance import StanceConfig

_PLANE = gtsam.Cal3_S2(1.0, 1.0, 0.0, 0.0, 0.0)


class GraphConfig(Config):
    """What is believed besides the images."""

    road_sigma_m: SigmaM = 0.02
    stance: StanceConfig = StanceConfig()
    road_bend_per_m: SigmaRad = 0.01
    level_sigma_rad: SigmaRad = 0.1
    level_height_sigma_m: SigmaM = 0.5
    rear_axle: RearAxleConfig = RearAxleConfig()
    iterations: StepCount = 12
    relative_tolerance: PositiveShare = 1e-3


def pose_key(keyframe: int) -> int:
    return int(gtsam.symbol("x", keyframe))


def camera_key(camera: int) -> int:
    return int(gtsam.symbol("e", camera))


def landmark_key(landmark: int) -> int:
    return int(gtsam.symbol("l", landmark))


def slip_key() -> int:
    return int(gtsam.symbol("s", 0))


def to_gtsam(pose: SE3) -> gtsam.Pose3:
    return gtsam.Pose3(gtsam.Rot3.ClosestTo(pose.rotation), pose.translation)


def from_gtsam(pose: gtsam.Pose3) -> SE3:
    return SE3(pose.rotation().matrix(), np.asarray(pose.translation()))


def add_poses(
    graph: gtsam.NonlinearFactorGraph, values: gtsam.Values, scene: Scene, config: GraphConfig, fixed: bool
) -> None:
    tilt, height = config.level_sigma_rad, config.level_height_sigma_m
    gauge = gtsam.noiseModel.Diagonal.Sigmas(np.array([tilt, tilt, 1e-5, 1e-4, 1e-4, height]))
    ride = gtsam.noiseModel.Diagonal.Sigmas(np.array([tilt, tilt, 1e3, 1e3, 1e3, height]))
    rigid = gtsam.noiseModel.Isotropic.Sigma(6, 1e-6)
    for index, pose in enumerate(scene.world_from_egos):
        values.insert(pose_key(index), to_gtsam(pose))
        level = to_gtsam(flattened(pose))
        if fixed:
            graph.add(gtsam.PriorFactorPose3(pose_key(index), to_gtsam(pose), rigid))
        else:
            graph.add(gtsam.PriorFactorPose3(pose_key(index), level, ride if index else gauge))


def flattened(pose: SE3) -> SE3:
    """Return the pose with its heading and place kept, upright on z = 0."""
    heading = np.arctan2(pose.rotation[1, 0], pose.rotation[0, 0])
    flat = SE3.exp(np.array([0.0, 0.0, heading, 0.0, 0.0, 0.0])).rotation
    return SE3(flat, pose.translation * np.array([1.0, 1.0, 0.0]))


def add_kinematics(
    graph: gtsam.NonlinearFactorGraph, values: gtsam.Values, scene: Scene, config: GraphConfig
) -> None:
    poses = scene.world_from_egos
    if scene.stamps_ns:
        keys = [pose_key(index) for index in range(len(poses))]
        add_rear_axle(graph, values, poses, scene.stamps_ns, keys, slip_key(), config.rear_axle)


def add_landmarks(
    graph: gtsam.NonlinearFactorGraph,
    values: gtsam.Values,
    scene: Scene,
    observations: Observations,
    indeterminate: Mask,
) -> None:
    centre = np.mean([p.translation for p in scene.world_from_egos], axis=0)
    for index in np.unique(observations.landmark):
        point = scene.points_world[index]
        values.insert(landmark_key(index), point)
        # So weak that it moves nothing, but for landmarks that the images leave indeterminate in depth: those
        # would make GTSAM give up the whole window.
        share = 0.3 if indeterminate[index] else 20.0
        far = gtsam.noiseModel.Isotropic.Sigma(3, share * max(1.0, float(np.linalg.norm(point - centre))))
        graph.add(gtsam.PriorFactorPoint3(landmark_key(index), point, far))


def add_sightings(
    graph: gtsam.NonlinearFactorGraph, scene: Scene, observations: Observations, loss: Loss
) -> None:
    for index, (name, mounted) in enumerate(scene.rig.cameras.items()):
        mine = observations.select(observations.camera == index)
        rays = mounted.camera.unproject(mine.pixels)
        plane = rays[:, :2] / rays[:, 2:]
        on_plane = np.column_stack([plane, np.ones(len(plane))])
        by_plane = mounted.camera.project_with_jacobian(on_plane)[1][:, :, :2]
        body_from_sensor = to_gtsam(mounted.ego_from_cam)
        for row in range(len(mine)):
            noise = _noise(by_plane[row], float(mine.sigma_px[row]), loss)
            pose, point = pose_key(mine.keyframe[row]), landmark_key(mine.landmark[row])
            if name == scene.rig.reference:
                graph.add(
                    gtsam.GenericProjectionFactorCal3_S2(
                        plane[row], noise, pose, point, _PLANE, body_from_sensor
                    )
                )
            else:
                graph.add(
                    gtsam_unstable.ProjectionFactorPPPCal3_S2(
                        plane[row], noise, pose, camera_key(index), point, _PLANE
                    )
                )


def _noise(pixels_by_plane: Array, sigma_px: float, loss: Loss) -> gtsam.noiseModel.Base:
    """Whiten a residual on the plane to pixels over sigma, then bound its say."""
    base = gtsam.noiseModel.Gaussian.SqrtInformation(pixels_by_plane / sigma_px)
    return gtsam.noiseModel.Robust.Create(
        gtsam.noiseModel.mEstimator.Cauchy.Create(loss.in_sigmas(sigma_px)), base
    )


def estimated(scene: Scene) -> list[tuple[int, str]]:
    """Return index and name of the cameras whose pose is a variable."""
    return [(i, name) for i, name in enumerate(scene.rig.cameras) if name != scene.rig.reference]


def add_cameras(
    graph: gtsam.NonlinearFactorGraph, values: gtsam.Values, scene: Scene, belief: Belief
) -> None:
    """Add the extrinsics and one joint prior on them: |R (x - mean)|^2 with R^T R the inverse covariance."""
    means = gtsam.Values()
    terms = []
    whitener = np.linalg.cholesky(np.linalg.inv(belief.covariance)).T
    for block, (index, name) in enumerate(estimated(scene)):
        values.insert(camera_key(index), to_gtsam(scene.rig[name].ego_from_cam))
        means.insert(camera_key(index), to_gtsam(belief.rig[name].ego_from_cam))
        terms.append((camera_key(index), whitener[:, 6 * block : 6 * block + 6]))
    if not terms:
        return
    # A conditional is the one linear factor that the wrapper builds over any number of variables.
    unit = gtsam.noiseModel.Unit.Create(len(whitener))
    joint = gtsam.GaussianConditional(terms, len(terms), np.zeros(len(whitener)), unit)
    graph.add(gtsam.LinearContainerFactor(gtsam.JacobianFactor(joint), means))
