"""What an estimator answers: every camera's pose with its uncertainty and the evidence for it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum

import numpy as np

from estimator.camera import Camera
from estimator.finding import Finding
from estimator.scale import ScaleEvidence
from estimator.se3 import SE3, Array


class Status(StrEnum):
    """How far a camera's estimate may be relied on."""

    INITIALISING = "initialising"
    CONVERGED = "converged"
    WEAK = "weak"
    SUSPECT = "suspect"
    MOVED = "moved"
    LOST = "lost"


Axes = tuple[bool, bool, bool, bool, bool, bool]
ALL_AXES: Axes = (True, True, True, True, True, True)


@dataclass(frozen=True, eq=False)
class CameraEstimate:
    """One camera's pose.

    Attributes:
        ego_from_cam: The estimated extrinsics.
        covariance: (6, 6), tangent (rotation rad, translation m) of the right perturbation: camera frame.
        status: How far to rely on it.
        inlier_count: Observations by this camera that support the estimate so far.
        observed: For each axis of the covariance (rx, ry, rz, tx, ty, tz), whether the drive itself has made
            it observable, and not the prior; None if the estimator does not say.
        weak_axes: What is not observed, in words: pitch, yaw, roll, forward, sideways, height.
        camera: The refined intrinsics; None where those of the rig file were used.
    """

    ego_from_cam: SE3
    covariance: Array
    status: Status
    inlier_count: int = 0
    observed: Axes | None = None
    weak_axes: tuple[str, ...] = ()
    camera: Camera | None = None

    @property
    def sigma(self) -> Array:
        """The (6,) standard deviations of the tangent."""
        return np.sqrt(np.diag(self.covariance))


@dataclass(frozen=True, eq=False)
class Match:
    """One landmark seen by two cameras, perhaps at two instants, for people to look at."""

    camera_a: str
    stamp_a_ns: int
    pixel_a: tuple[float, float]
    camera_b: str
    stamp_b_ns: int
    pixel_b: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Estimate:
    """The state after one bundle, or, from ``close()``, after the whole drive.

    Attributes:
        stamp_ns: Stamp of the newest bundle it accounts for.
        cameras: Every camera of the rig, the reference too (its covariance is zero).
        world_from_ego: Pose of the car; None while the motion is unknown. The world is the estimator's own:
            gravity-aligned, origin at the ego frame of the first bundle.
        trajectory: From ``close()`` only: the refined (stamp_ns, world_from_ego) of the drive.
        tracks_px: By camera, (N, 4) previous and present pixel (u0, v0, u1, v1) of the tracks now alive.
        matches: Cross-camera matches that the newest window used; empty between windows.
        stage_s: Wall seconds of this update by stage.
        findings: What was noticed and still holds.
        scale: Where the metres come from and how sure they are; None before anything is learnt.
    """

    stamp_ns: int
    cameras: Mapping[str, CameraEstimate]
    world_from_ego: SE3 | None = None
    trajectory: Sequence[tuple[int, SE3]] = ()
    tracks_px: Mapping[str, Array] = field(default_factory=dict)
    matches: Sequence[Match] = ()
    stage_s: Mapping[str, float] = field(default_factory=dict)
    findings: Sequence[Finding] = ()
    scale: ScaleEvidence | None = None
