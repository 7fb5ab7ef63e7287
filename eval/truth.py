"""The truth a recording may carry: the car's path and the cameras' true poses. Read only here."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from estimator.bag import Bag
from estimator.bag_rosbags import parse
from estimator.errors import InputError
from estimator.se3 import SE3

_ODOMETRY = "/truth/odometry"
_EXTRINSICS = "/truth/extrinsics"
_NS = 1_000_000_000


@dataclass(frozen=True, eq=False)
class TruthTrack:
    """What truly happened.

    Attributes:
        stamps_ns: Instants of the path, strictly increasing.
        world_from_ego: The car's pose at each of them.
        extrinsics: (stamp_ns, ego_from_cam by camera) after every change, by increasing stamp.
    """

    stamps_ns: Sequence[int]
    world_from_ego: Sequence[SE3]
    extrinsics: Sequence[tuple[int, Mapping[str, SE3]]]

    def ego_from_cams_at(self, stamp_ns: int) -> Mapping[str, SE3]:
        """Return the true extrinsics in force at an instant; before the first message, the first ones."""
        index = bisect_right([stamp for stamp, _ in self.extrinsics], stamp_ns) - 1
        return self.extrinsics[max(index, 0)][1]


def read_truth(path: Path | str) -> TruthTrack | None:
    """Read the truth of a recording, up to the break if it is broken off; None if it carries none.

    Raises:
        InputError: No recording there, or a truth that cannot be.
    """
    poses: dict[int, SE3] = {}
    transforms: list[tuple[int, str, SE3]] = []
    with Bag(path) as bag:
        for message in bag.messages((_ODOMETRY, _EXTRINSICS)):
            content = parse(message)
            try:
                if message.topic == _ODOMETRY:
                    poses[message.header_stamp_ns] = _pose(content.pose.pose)
                else:
                    transforms.extend(_transform(each) for each in content.transforms if _is_mounting(each))
            except (AttributeError, ValueError) as error:
                raise InputError(f"{path}: topic {message.topic}: {error}") from None
    if not poses or not transforms:
        return None
    stamps_ns = sorted(poses)
    return TruthTrack(stamps_ns, [poses[stamp] for stamp in stamps_ns], _accumulated(transforms))


def _accumulated(transforms: Sequence[tuple[int, str, SE3]]) -> list[tuple[int, Mapping[str, SE3]]]:
    """Carry the poses of the cameras that a message leaves out over from the messages before it."""
    steps: dict[int, Mapping[str, SE3]] = {}
    current: dict[str, SE3] = {}
    for stamp_ns, camera, ego_from_cam in sorted(transforms, key=lambda each: each[0]):
        current = {**current, camera: ego_from_cam}
        steps[stamp_ns] = current
    return list(steps.items())


def _is_mounting(stamped: Any) -> bool:
    return str(stamped.header.frame_id).strip("/") == "ego"


def _transform(stamped: Any) -> tuple[int, str, SE3]:
    stamp = stamped.header.stamp
    camera = stamped.child_frame_id.strip("/")
    transform = stamped.transform
    return stamp.sec * _NS + stamp.nanosec, camera, _se3(transform.rotation, transform.translation)


def _pose(pose: Any) -> SE3:
    return _se3(pose.orientation, pose.position)


def _se3(rotation: Any, translation: Any) -> SE3:
    quaternion_xyzw = np.array([rotation.x, rotation.y, rotation.z, rotation.w])
    translation_m = np.array([translation.x, translation.y, translation.z])
    if not np.isfinite(translation_m).all() or not abs(np.linalg.norm(quaternion_xyzw) - 1) < 1e-3:
        raise ValueError(
            f"got the pose {translation_m.tolist()}, {quaternion_xyzw.tolist()}, wanted a rotation"
        )
    return SE3.from_quaternion_xyzw(quaternion_xyzw, translation_m)
