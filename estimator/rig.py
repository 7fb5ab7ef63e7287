"""A rig: cameras mounted on one rigid body, one of them the reference whose pose is known."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from estimator.camera import Camera
from estimator.errors import InputError
from estimator.se3 import SE3, Array


@dataclass(frozen=True)
class MountedCamera:
    """A camera with its extrinsics ``ego_from_cam`` (ego: x forward, y left, z up, under the rear axle)."""

    camera: Camera
    ego_from_cam: SE3


@dataclass(frozen=True)
class RigPrior:
    """How far a nominal pose may be off: norms of the rotation and translation error."""

    rotation_deg: float = 3.0
    translation_mm: float = 100.0

    @property
    def covariance(self) -> Array:
        """The (6, 6) covariance in the tangent of ``ego_from_cam``; sigma per axis is the norm / sqrt(3)."""
        rotation_rad = np.deg2rad(self.rotation_deg) / np.sqrt(3)
        translation_m = self.translation_mm / 1000 / np.sqrt(3)
        return np.diag([rotation_rad**2] * 3 + [translation_m**2] * 3)


@dataclass(frozen=True)
class Rig:
    """Named mounted cameras, the reference among them, and the prior of the others' poses."""

    reference: str
    cameras: Mapping[str, MountedCamera]
    prior: RigPrior = RigPrior()

    def __post_init__(self) -> None:
        if self.reference not in self.cameras:
            raise InputError(
                f"reference camera {self.reference!r} is not in the rig; cameras: {self.names_text}"
            )

    @property
    def names_text(self) -> str:
        return ", ".join(self.cameras)

    @property
    def estimated_names(self) -> tuple[str, ...]:
        """The cameras whose pose is sought: all but the reference, in the order of the rig."""
        return tuple(name for name in self.cameras if name != self.reference)

    def __getitem__(self, name: str) -> MountedCamera:
        if name not in self.cameras:
            raise InputError(f"camera {name!r} is not in the rig; cameras: {self.names_text}")
        return self.cameras[name]

    def with_extrinsics(self, ego_from_cams: Mapping[str, SE3]) -> Rig:
        """Return a rig with some cameras moved."""
        cameras = {
            name: replace(mounted, ego_from_cam=ego_from_cams.get(name, mounted.ego_from_cam))
            for name, mounted in self.cameras.items()
        }
        return replace(self, cameras=cameras)
