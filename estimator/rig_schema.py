"""The rig file's keys and what they may hold. Turns them into a ``Rig``; reads and writes no file."""

from __future__ import annotations

import re
from typing import Annotated

import numpy as np
from pydantic import AfterValidator, Field, Strict, ValidationInfo, field_validator, model_validator

from estimator.camera import COEFFICIENT_COUNT, Camera, CameraModel
from estimator.config import Config
from estimator.rig import MountedCamera, Rig, RigPrior
from estimator.se3 import SE3

_UNIT_TOLERANCE = 1e-3
_RESERVED_NAMES = frozenset({"worst", "median"})  # they name metrics over all cameras


def _check_unit(quaternion_xyzw: tuple[float, float, float, float]) -> tuple[float, float, float, float]:
    norm = float(np.linalg.norm(quaternion_xyzw))
    if abs(norm - 1.0) > _UNIT_TOLERANCE:
        raise ValueError(f"got a quaternion of norm {norm:.6g}, wanted a rotation: norm 1")
    return quaternion_xyzw


def _check_name(name: str) -> str:
    if not re.fullmatch(r"[^\s/.\[\]]+", name) or name in _RESERVED_NAMES:
        raise ValueError(
            f"got the camera name {name!r}, wanted a topic name: not empty, without '/', '.', brackets or "
            f"spaces, none of {', '.join(sorted(_RESERVED_NAMES))}"
        )
    return name


Number = Annotated[float, Strict()]
Positive = Annotated[float, Strict(), Field(gt=0)]
PixelCount = Annotated[int, Strict(), Field(gt=0, le=100_000)]
Name = Annotated[str, Strict(), AfterValidator(_check_name)]
UnitQuaternion = Annotated[tuple[Number, Number, Number, Number], AfterValidator(_check_unit)]

_LEAST_SIGHT = 0.5  # the corners of a fisheye image may be dark


class PoseEntry(Config):
    """``ego_from_cam``: where a camera sits."""

    translation_m: tuple[Number, Number, Number]
    quaternion_xyzw: UnitQuaternion


class CameraEntry(Config):
    """One camera: intrinsics, distortion in OpenCV's order, extrinsics."""

    model: CameraModel
    size_px: tuple[PixelCount, PixelCount]
    focal_px: tuple[Positive, Positive]
    center_px: tuple[Number, Number]
    distortion: tuple[Number, ...] = Field((), validate_default=True)
    ego_from_cam: PoseEntry

    @field_validator("distortion")
    @classmethod
    def _check_count(cls, distortion: tuple[float, ...], info: ValidationInfo) -> tuple[float, ...]:
        model: CameraModel | None = info.data.get("model")
        if model is not None and len(distortion) != COEFFICIENT_COUNT[model]:
            wanted = f"{COEFFICIENT_COUNT[model]} for {model}"
            raise ValueError(f"got {len(distortion)} coefficients, wanted {wanted}")
        return distortion

    @model_validator(mode="after")
    def _check_sight(self) -> CameraEntry:
        """Refuse a lens that turns back on itself within most of its own image."""
        width, height = self.size_px
        across, down = np.meshgrid(np.linspace(0, width - 1, 17), np.linspace(0, height - 1, 11))
        rays = self.camera().unproject(np.column_stack([across.ravel(), down.ravel()]))
        share = float(np.isfinite(rays).all(1).mean())
        if share < _LEAST_SIGHT:
            raise ValueError(
                f"got intrinsics and distortion that give {share:.0%} of the image a viewing ray, "
                f"wanted at least {_LEAST_SIGHT:.0%}"
            )
        return self

    def camera(self) -> Camera:
        return Camera(self.model, self.size_px, self.focal_px, self.center_px, self.distortion)

    def mounted(self) -> MountedCamera:
        pose = self.ego_from_cam
        return MountedCamera(
            self.camera(),
            SE3.from_quaternion_xyzw(np.array(pose.quaternion_xyzw), np.array(pose.translation_m)),
        )


class PriorEntry(Config):
    """How far the poses may be off; norms, not sigmas per axis."""

    rotation_deg: Positive = RigPrior().rotation_deg
    translation_mm: Positive = RigPrior().translation_mm


class RigEntry(Config):
    """The whole file. The cameras come first, because the reference is checked against them."""

    cameras: dict[Name, CameraEntry]
    reference: Name
    prior: PriorEntry = PriorEntry()

    @field_validator("reference")
    @classmethod
    def _check_reference(cls, reference: str, info: ValidationInfo) -> str:
        cameras = info.data.get("cameras")
        if cameras is not None and reference not in cameras:
            there = ", ".join(cameras) or "none"
            raise ValueError(f"got {reference!r}, wanted one of the cameras; there are: {there}")
        if cameras is not None and cameras[reference].ego_from_cam.translation_m[2] <= 0:
            height_m = cameras[reference].ego_from_cam.translation_m[2]
            raise ValueError(
                f"got {reference!r}, whose translation_m has z = {height_m:g}, wanted a camera above "
                "the road, z = 0: its height gives the scale"
            )
        return reference

    def rig(self) -> Rig:
        cameras = {name: entry.mounted() for name, entry in self.cameras.items()}
        return Rig(self.reference, cameras, RigPrior(self.prior.rotation_deg, self.prior.translation_mm))
