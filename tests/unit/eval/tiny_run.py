"""A tiny run with known errors, for the tests of metrics and of the report."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from estimator.bundle import FrameBundle
from estimator.camera import Camera
from estimator.estimate import CameraEstimate, Estimate, Match, Status
from estimator.rig import MountedCamera, Rig
from estimator.se3 import SE3, Array
from eval.collect import RunLog
from eval.truth import TruthTrack

LOOKING_AHEAD = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
CAMERA = Camera("pinhole", (64, 40), (40.0, 40.0), (31.5, 19.5))
STEP_NS = 100_000_000
START_NS = 1_700_000_000_000_000_000
SIGMA = np.diag([1e-3**2] * 3 + [0.01**2] * 3)


def looking(yaw_deg: float, x_m: float, y_m: float) -> SE3:
    """Return the ego_from_cam of a camera 1 m high that looks ``yaw_deg`` to the left."""
    turn = SE3.exp(np.array([0, 0, np.radians(yaw_deg), 0, 0, 0]))
    return SE3(turn.rotation @ LOOKING_AHEAD, np.array([x_m, y_m, 1.0]))


TRUE_POSES = {"front": looking(0, 2, 0), "left": looking(60, 1, 0.9), "rear": looking(180, -1, 0)}
RIG = Rig("front", {name: MountedCamera(CAMERA, pose) for name, pose in TRUE_POSES.items()})


def straight(count: int, step_m: float = 1.0) -> list[SE3]:
    """Return poses ``step_m`` apart along x."""
    return [SE3(np.eye(3), np.array([step_m * index, 0.0, 0.0])) for index in range(count)]


def stamps(count: int) -> list[int]:
    return [START_NS + STEP_NS * index for index in range(count)]


def truth_of(path: Sequence[SE3], moves: Sequence[tuple[int, Mapping[str, SE3]]] = ()) -> TruthTrack:
    """Return the truth along a path; ``moves`` are (bundle, new poses of some cameras)."""
    extrinsics = [(START_NS, TRUE_POSES)]
    extrinsics += [(START_NS + STEP_NS * index, {**TRUE_POSES, **poses}) for index, poses in moves]
    return TruthTrack(stamps(len(path)), list(path), extrinsics)


def off_by(rotation_deg: float, translation_mm: float) -> Array:
    """Return a tangent of exactly this angle about x and this length along y."""
    return np.array([np.radians(rotation_deg), 0, 0, 0, translation_mm / 1000, 0])


def camera_estimates(
    errors: Mapping[str, Array], statuses: Mapping[str, Status] | None = None, covariance: Array = SIGMA
) -> dict[str, CameraEstimate]:
    """Return estimates that are ``errors`` away from the truth; cameras without an error are exact."""
    return {
        name: CameraEstimate(
            pose.retract(errors.get(name, np.zeros(6))),
            np.zeros((6, 6)) if name == RIG.reference else covariance,
            (statuses or {}).get(name, Status.CONVERGED),
            7,
        )
        for name, pose in TRUE_POSES.items()
    }


def run_log(
    path: Sequence[SE3],
    errors_at: Callable[[int], Mapping[str, Array]] = lambda index: {},
    statuses_at: Callable[[int], Mapping[str, Status]] = lambda index: {},
    final: Mapping[str, CameraEstimate] | None = None,
    trajectory: Sequence[tuple[int, SE3]] = (),
) -> RunLog:
    """Return the log of an estimator that errs as told, whose own path is ``path``."""
    log = RunLog(RIG)
    image = np.tile(np.arange(64, dtype=np.uint8) * 3, (40, 1))
    for index, (stamp, pose) in enumerate(zip(stamps(len(path)), path, strict=True)):
        tracks = {name: np.array([[10.0 + index, 20.0, 11.0 + index, 20.0]]) for name in TRUE_POSES}
        matches = [Match("left", stamp, (5.0, 6.0), "front", stamp, (7.0, 8.0))]
        estimate = Estimate(
            stamp,
            camera_estimates(errors_at(index), statuses_at(index)),
            pose,
            tracks_px=tracks,
            matches=matches,
            stage_s={"track": 0.01, "window": 0.02},
        )
        with log.measuring():
            pass
        log.add(FrameBundle(stamp, dict.fromkeys(TRUE_POSES, image)), estimate)
    cameras = dict(log.entries[-1].cameras) if final is None else dict(final)
    log.finish(Estimate(log.last_stamp_ns, cameras, trajectory=trajectory, stage_s={"window": 0.1}))
    return log
