"""The truth of a recording: path, extrinsics in force, and none."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from estimator.errors import InputError
from estimator.se3 import SE3
from eval.truth import read_truth
from tests.bag_messages import NS, extrinsics_message, odometry_message
from tests.bags import Entry, frames_of, raw_entries, small_rig, truth_entries, write_bag

STAMPS_NS = [NS + index * 100_000_000 for index in range(6)]
POSES = {name: SE3.exp(np.arange(6) * 0.1 + index) for index, name in enumerate(("front", "left", "rear"))}
KNOCKED = SE3.exp(np.full(6, 0.3))


def assert_same(a: SE3, b: SE3) -> None:
    np.testing.assert_allclose(a.matrix, b.matrix, atol=1e-12)


def test_the_path_and_the_poses_arrive(tmp_path: Path) -> None:
    truth = read_truth(write_bag(tmp_path / "bag", truth_entries(POSES, STAMPS_NS, speed_mps=5.0)))
    assert truth is not None
    assert list(truth.stamps_ns) == STAMPS_NS
    np.testing.assert_allclose([pose.translation[0] for pose in truth.world_from_ego], np.arange(6) * 0.5)
    for name, pose in POSES.items():
        assert_same(truth.ego_from_cams_at(STAMPS_NS[-1])[name], pose)


def test_a_change_holds_from_its_stamp_on_and_leaves_the_other_cameras(tmp_path: Path) -> None:
    knock = Entry("/truth/extrinsics", extrinsics_message({"rear": KNOCKED}, STAMPS_NS[3]), STAMPS_NS[3])
    truth = read_truth(write_bag(tmp_path / "bag", [*truth_entries(POSES, STAMPS_NS), knock]))
    assert truth is not None
    assert_same(truth.ego_from_cams_at(STAMPS_NS[3] - 1)["rear"], POSES["rear"])
    assert_same(truth.ego_from_cams_at(STAMPS_NS[3])["rear"], KNOCKED)
    assert_same(truth.ego_from_cams_at(STAMPS_NS[5])["left"], POSES["left"])
    assert_same(truth.ego_from_cams_at(0)["rear"], POSES["rear"])


def test_transforms_of_other_frames_are_not_mountings(tmp_path: Path) -> None:
    message = extrinsics_message({"wheel": KNOCKED}, STAMPS_NS[0])
    message.transforms[0].header.frame_id = "chassis"
    entries = [*truth_entries(POSES, STAMPS_NS), Entry("/truth/extrinsics", message, STAMPS_NS[0])]
    truth = read_truth(write_bag(tmp_path / "bag", entries))
    assert truth is not None
    assert truth.ego_from_cams_at(STAMPS_NS[0]).keys() == POSES.keys()


def test_a_bag_without_truth_has_none(tmp_path: Path) -> None:
    assert read_truth(write_bag(tmp_path / "bag", raw_entries(frames_of(small_rig())))) is None


def test_a_rotation_that_is_none_is_refused(tmp_path: Path) -> None:
    message = odometry_message(SE3(), STAMPS_NS[0])
    message.pose.pose.orientation.w = 0.0
    entries = [*truth_entries(POSES, STAMPS_NS[1:]), Entry("/truth/odometry", message, STAMPS_NS[0])]
    with pytest.raises(InputError, match=r"/truth/odometry.*wanted a rotation"):
        read_truth(write_bag(tmp_path / "bag", entries))
