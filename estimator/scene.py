"""A window's unknowns at their present values: poses of the car, poses of the cameras, landmarks.

Also the geometry that every later step needs of them: where rays go, where landmarks should appear.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from estimator.clocks import Clocks
from estimator.corridor_config import CorridorConfig
from estimator.observations import Index, Mask, Observations
from estimator.rig import Rig
from estimator.se3 import SE3, Array
from estimator.triangulate import triangulate


@dataclass(frozen=True, eq=False)
class Scene:
    """Present values of a window's unknowns.

    Attributes:
        rig: Cameras with their present extrinsics.
        world_from_egos: Pose of the car at each keyframe; the road is near world z = 0.
        points_world: (M, 3) landmarks; NaN where unknown.
        stamps_ns: When each keyframe was; empty where nobody asks how fast the car went.
        clocks: Stamps and clocks that are ahead; None where all cameras look at the same instant.
        corridor: Where the car drives.
    """

    rig: Rig
    world_from_egos: tuple[SE3, ...]
    points_world: Array
    stamps_ns: tuple[int, ...] = ()
    clocks: Clocks | None = None
    corridor: CorridorConfig = field(default_factory=CorridorConfig)

    def camera_pose(self, camera: int, keyframe: int) -> SE3:
        """Return ``world_from_cam`` of one camera at one keyframe."""
        rotation, translation = self.pose_arrays(np.array([camera]), np.array([keyframe]))
        return SE3(rotation[0], translation[0])

    def pose_arrays(self, camera: Index, keyframe: Index) -> tuple[Array, Array]:
        """Return (N, 3, 3) rotations and (N, 3) translations of ``world_from_cam``."""
        mounted = [m.ego_from_cam for m in self.rig.cameras.values()]
        rotation_cam = np.stack([p.rotation for p in mounted])[camera]
        translation_cam = np.stack([p.translation for p in mounted])[camera]
        if self.clocks is None:
            rotation_ego = np.stack([p.rotation for p in self.world_from_egos])[keyframe]
            translation_ego = np.stack([p.translation for p in self.world_from_egos])[keyframe]
        else:
            rotations, translations = self.clocks.stances(self.world_from_egos)
            rotation_ego, translation_ego = rotations[keyframe, camera], translations[keyframe, camera]
        rotation = rotation_ego @ rotation_cam
        return rotation, np.einsum("nij,nj->ni", rotation_ego, translation_cam) + translation_ego

    def unproject(self, camera: Index, pixels: Array) -> Array:
        """Return (N, 3) unit rays, each in its own camera frame."""
        rays = np.full((len(pixels), 3), np.nan)
        for index, mounted in enumerate(self.rig.cameras.values()):
            mine = camera == index
            if mine.any():
                rays[mine] = mounted.camera.unproject(pixels[mine])
        return rays

    def project(self, camera: Index, points_cam: Array) -> Array:
        """Return (N, 2) pixels; NaN where the camera cannot see the point."""
        pixels = np.full((len(points_cam), 2), np.nan)
        for index, mounted in enumerate(self.rig.cameras.values()):
            mine = camera == index
            if mine.any():
                pixels[mine] = mounted.camera.project(points_cam[mine])
        return pixels

    def predict(self, camera: Index, keyframe: Index, points_world: Array) -> Array:
        """Return (N, 2) pixels at which points appear in given cameras at given keyframes."""
        rotation, translation = self.pose_arrays(camera, keyframe)
        points_cam = np.einsum("nji,nj->ni", rotation, points_world - translation)
        return self.project(camera, points_cam)

    def as_if_in_time(self, observations: Observations) -> Observations:
        """Return what the cameras would have seen of known landmarks with clocks that are right."""
        if self.clocks is None:
            return observations
        points = self.points_world[observations.landmark]
        late = self.predict(observations.camera, observations.keyframe, points)
        in_time = replace(self, clocks=None).predict(observations.camera, observations.keyframe, points)
        moved = observations.pixels + np.nan_to_num(in_time - late)
        return replace(observations, pixels=moved)

    def residuals_px(self, observations: Observations) -> Array:
        """Return the (N,) distances between prediction and measurement; NaN where there is none."""
        points = self.points_world[observations.landmark]
        predicted = self.predict(observations.camera, observations.keyframe, points)
        return np.asarray(np.linalg.norm(predicted - observations.pixels, axis=1))

    def with_triangulated(self, observations: Observations, wanted: Mask) -> Scene:
        """Return the scene with the wanted landmarks intersected anew."""
        rotation, center = self.pose_arrays(observations.camera, observations.keyframe)
        rays = np.einsum("nij,nj->ni", rotation, self.unproject(observations.camera, observations.pixels))
        points, angle = triangulate(observations.landmark, rays, center, len(self.points_world))
        points[angle < _MIN_ANGLE_RAD] = np.nan
        return replace(self, points_world=np.where(wanted[:, None], points, self.points_world))


_MIN_ANGLE_RAD = 0.01
