"""The car's path from the reference camera's tracks, on a path that is known."""

from __future__ import annotations

import numpy as np

from estimator.odometry import Odometry, OdometryConfig
from estimator.rig import MountedCamera
from estimator.se3 import SE3, Array
from estimator.tracker import Tracker, TrackerConfig
from tests.canyon import cast
from tests.mounts import BROWN, FISHEYE, PINHOLE, arc, left_side_rig

PATH = arc(0.6, 8)


class Drive:
    """Tracks of points in the canyon, seen without noise; the first view anchors them."""

    def __init__(self, mounted: MountedCamera, count: int = 400) -> None:
        self.mounted = mounted
        self.odometry = Odometry(mounted, OdometryConfig())
        self.tracker = Tracker(mounted.camera, TrackerConfig())
        pixels = np.random.default_rng(0).uniform(5, np.array(mounted.camera.size_px) - 5, (count, 2))
        points = cast(PATH[0] @ mounted.ego_from_cam, mounted.camera.unproject(pixels))[0]
        self.points_world = points[np.isfinite(points[:, 0])]
        count = len(self.points_world)
        self.tracker.tracks.start(np.zeros((count, 2)), np.zeros((count, 3)))
        self.see(PATH[0])
        self.tracker.tracks.reanchor()
        self.tracker.tracks.anchor(PATH[0] @ mounted.ego_from_cam)

    def see(self, world_from_ego: SE3) -> None:
        points_cam = (world_from_ego @ self.mounted.ego_from_cam).inverse().apply(self.points_world)
        pixels = self.mounted.camera.project(points_cam)
        seen = self.mounted.camera.contains(pixels)
        self.tracker.tracks.pixels = pixels
        self.tracker.tracks.rays_cam = self.mounted.camera.unproject(pixels)
        self.tracker.tracks.keep(seen)
        self.points_world = self.points_world[seen]

    def advance(self, world_from_ego: SE3) -> bool:
        self.see(world_from_ego)
        known = self.odometry.advance(self.tracker)
        if known:
            self.tracker.locate(self.odometry.world_from_ego @ self.mounted.ego_from_cam)
        return known


def error(odometry: Odometry, true: SE3) -> Array:
    return np.abs(true.local(odometry.world_from_ego))


def test_two_views_start_it_at_the_scale_of_the_road() -> None:
    for lens in (PINHOLE, BROWN, FISHEYE):
        drive = Drive(left_side_rig(lens)["front"])
        assert drive.advance(PATH[2])
        assert drive.odometry.metric
        length_m = np.linalg.norm(drive.odometry.world_from_ego.translation)
        assert abs(length_m / np.linalg.norm(PATH[2].translation) - 1) < 0.01


def test_then_it_follows_the_path() -> None:
    drive = Drive(left_side_rig()["front"])
    drive.advance(PATH[1])
    for pose in PATH[2:]:
        assert drive.advance(pose)
        assert error(drive.odometry, pose)[:3].max() < 1e-3 and error(drive.odometry, pose)[3:].max() < 0.05
    assert abs(drive.odometry.step_m - 0.6) < 0.01


def test_a_standing_car_does_not_start_it() -> None:
    drive = Drive(left_side_rig()["front"])
    assert not drive.advance(PATH[0])
    assert not drive.odometry.metric


def test_a_creep_of_a_few_centimetres_does_not_start_it() -> None:
    drive = Drive(left_side_rig()["front"])
    assert not drive.advance(arc(0.08, 2)[1])


def test_a_turn_on_the_spot_of_the_camera_does_not_start_it() -> None:
    mount = left_side_rig()["front"].ego_from_cam
    turn = SE3.exp(np.array([0.0, 0.03, 0.0, 0.0, 0.0, 0.0]))
    drive = Drive(left_side_rig()["front"])
    assert not drive.advance(PATH[0] @ mount @ turn @ mount.inverse())


def test_few_tracks_do_not_start_it() -> None:
    drive = Drive(left_side_rig()["front"], 20)
    assert not drive.advance(PATH[2])


def test_without_tracks_it_goes_on_as_before_and_counts() -> None:
    drive = Drive(left_side_rig()["front"])
    for pose in PATH[1:5]:
        drive.advance(pose)
    drive.tracker.forget()
    assert not drive.odometry.advance(drive.tracker)
    assert drive.odometry.lost_count == 1
    assert error(drive.odometry, PATH[5])[3:].max() < 0.05


def test_while_tracks_wait_for_an_image_the_car_goes_on_as_before() -> None:
    drive = Drive(left_side_rig()["front"])
    for pose in PATH[1:4]:
        drive.advance(pose)
    drive.tracker.missed_count = 1
    for pose in PATH[4:6]:
        assert not drive.odometry.advance(drive.tracker)
        assert error(drive.odometry, pose)[3:].max() < 0.1
    assert drive.odometry.metric and drive.odometry.lost_count == 0
    drive.tracker.missed_count = 0
    assert drive.advance(PATH[6])
    assert abs(drive.odometry.step_m - 0.6) < 0.01, "three bundles' way is not one step"


def test_a_correction_moves_the_pose_and_stretches_the_step() -> None:
    drive = Drive(left_side_rig()["front"])
    for pose in PATH[1:4]:
        drive.advance(pose)
    step_m = drive.odometry.step_m
    drive.odometry.correct(PATH[3], 1.1)
    np.testing.assert_allclose(drive.odometry.world_from_ego.matrix, PATH[3].matrix)
    np.testing.assert_allclose(drive.odometry.step_m, 1.1 * step_m)


def test_a_restart_keeps_the_place_and_forgets_the_scale() -> None:
    drive = Drive(left_side_rig()["front"])
    drive.advance(PATH[1])
    place = drive.odometry.world_from_ego
    drive.odometry.restart()
    assert not drive.odometry.metric and drive.odometry.world_from_ego is place


def test_a_pose_that_all_cameras_agree_on_takes_the_place_of_the_reference_s_own() -> None:
    drive = Drive(left_side_rig()["front"])
    for pose in PATH[1:4]:
        drive.advance(pose)
    drive.odometry.settle(PATH[3])
    np.testing.assert_allclose(drive.odometry.world_from_ego.matrix, PATH[3].matrix)
    assert abs(drive.odometry.step_m - 0.6) < 0.05, "one bundle's way, not none"


def test_it_counts_as_measured_where_the_reference_knew_nothing() -> None:
    drive = Drive(left_side_rig()["front"])
    for pose in PATH[1:4]:
        drive.advance(pose)
    drive.tracker.forget()
    drive.odometry.advance(drive.tracker)
    drive.odometry.advance(drive.tracker)
    drive.odometry.settle(PATH[5])
    assert drive.odometry.lost_count == 0
    assert abs(drive.odometry.step_m - 0.6) < 0.05, "two bundles' way is not one step"
