"""The table of tracks: ids, first views, points, and when a track is given up."""

from __future__ import annotations

import numpy as np

from estimator.se3 import SE3
from estimator.tracker import Tracker, TrackerConfig
from tests.canyon import cast, render
from tests.mounts import PINHOLE, arc, left_side_rig

MOUNT = left_side_rig()["front"].ego_from_cam
CAMS = tuple(pose @ MOUNT for pose in arc(0.5, 4))
IMAGES = [render(PINHOLE, cam) for cam in CAMS]
ELSEWHERE = SE3.exp(np.array([0.1, 0.0, 0.3, 5.0, -2.0, 0.4]))


def started() -> Tracker:
    tracker = Tracker(PINHOLE, TrackerConfig())
    tracker.advance(IMAGES[0], np.zeros((0, 2)))
    tracker.replenish()
    tracker.tracks.anchor(CAMS[0])
    return tracker


def driven() -> Tracker:
    tracker = started()
    for index in (1, 2, 3):
        tracker.advance(IMAGES[index], tracker.predict(CAMS[index - 1], CAMS[index]))
        tracker.locate(CAMS[index])
    return tracker


def test_it_fills_up_to_its_places_and_no_further() -> None:
    tracker = started()
    assert len(tracker.tracks) == TrackerConfig().max_points
    tracker.replenish()
    assert len(tracker.tracks) == TrackerConfig().max_points


def test_an_id_is_given_once() -> None:
    tracker = started()
    old = tracker.tracks.ids
    tracker.tracks.keep(old % 2 == 0)
    tracker.replenish()
    assert len(np.unique(tracker.tracks.ids)) == len(tracker.tracks) > len(old) // 2
    assert tracker.tracks.ids[len(old) // 2 :].min() > old.max()


def test_tracks_follow_their_points_and_find_them() -> None:
    tracker = driven()
    true = cast(CAMS[0], tracker.tracks.anchor_rays_cam)[0]
    near = np.linalg.norm(true - CAMS[3].translation, axis=1) < 10
    known = np.isfinite(tracker.tracks.points_world[:, 0]) & near
    assert known.sum() > 30
    distance_m = np.linalg.norm(tracker.tracks.points_world[known] - true[known], axis=1)
    assert np.median(distance_m) < 0.2
    assert len(tracker.tracks) > 0.4 * TrackerConfig().max_points


def test_a_track_with_a_point_is_predicted_where_it_appears() -> None:
    tracker = driven()
    tracker.tracks.points_world = cast(CAMS[3], tracker.tracks.rays_cam)[0]
    before = CAMS[3] @ SE3.exp(np.array([0.0, 0.0, 0.0, 0.0, 0.0, -0.5]))
    predicted = tracker.predict(CAMS[3], before)
    wanted = PINHOLE.project(before.inverse().apply(tracker.tracks.points_world))
    inside = PINHOLE.contains(wanted)
    np.testing.assert_allclose(predicted[inside], wanted[inside])
    assert np.isfinite(predicted).all()


def test_a_track_without_a_point_that_looks_down_is_predicted_on_the_road() -> None:
    tracker = started()
    true = cast(CAMS[0], tracker.tracks.rays_cam)[0]
    road = (np.abs(true[:, 2]) < 1e-6) & (true[:, 0] < 9)
    wanted = PINHOLE.project(CAMS[1].inverse().apply(true))
    road &= PINHOLE.contains(wanted)
    assert road.sum() > 20
    np.testing.assert_allclose(tracker.predict(CAMS[0], CAMS[1])[road], wanted[road], atol=1e-6)


def test_tracks_wait_for_an_image_that_is_missing() -> None:
    tracker = driven()
    count = len(tracker.tracks)
    for missed in range(1, tracker.config.bridged_images + 1):
        tracker.miss()
        assert not tracker.current and tracker.missed_count == missed and len(tracker.tracks) == count
    tracker.advance(IMAGES[3], tracker.tracks.pixels)
    assert tracker.current and len(tracker.tracks) > 0


def test_images_missing_for_long_forget_everything() -> None:
    tracker = driven()
    for _ in range(tracker.config.bridged_images + 1):
        tracker.miss()
    assert len(tracker.tracks) == 0 and tracker.image is None
    tracker.advance(IMAGES[3], np.zeros((0, 2)))
    tracker.replenish()
    assert len(tracker.tracks) > 100


def test_an_image_of_another_size_starts_afresh() -> None:
    tracker = driven()
    tracker.advance(np.ascontiguousarray(IMAGES[3][:150]), tracker.tracks.pixels)
    assert len(tracker.tracks) == 0


def test_long_tracks_and_the_car_s_own_parts_are_given_up() -> None:
    tracker = started()
    count = len(tracker.tracks)
    tracker.tracks.pixels = tracker.tracks.pixels + 50.0
    tracker.tracks.pixels[:7] = tracker.tracks.anchor_pixels[:7]
    ahead = CAMS[0] @ SE3(np.eye(3), np.array([0.0, 0.0, 4.0]))
    tracker.retire(ahead)
    assert len(tracker.tracks) == count - 7
    tracker.retire(CAMS[0] @ SE3(np.eye(3), np.array([0.0, 0.0, 12.5])))
    assert len(tracker.tracks) == 0


def test_a_moved_world_takes_points_and_first_views_along() -> None:
    tracker = driven()
    points = tracker.tracks.points_world.copy()
    tracker.tracks.move_world(ELSEWHERE, 1.0, np.zeros(3))
    np.testing.assert_allclose(tracker.tracks.points_world, ELSEWHERE.apply(points))
    tracker.tracks.points_world[:] = np.nan
    tracker.locate(ELSEWHERE @ CAMS[3])
    known = np.isfinite(tracker.tracks.points_world[:, 0])
    assert known.sum() > 50
    np.testing.assert_allclose(tracker.tracks.points_world[known], ELSEWHERE.apply(points)[known], atol=1e-6)


def test_a_scaled_world_keeps_the_camera_it_is_scaled_about() -> None:
    tracker = driven()
    before = CAMS[3].inverse().apply(tracker.tracks.points_world)
    tracker.tracks.move_world(SE3(), 1.3, CAMS[3].translation)
    np.testing.assert_allclose(CAMS[3].inverse().apply(tracker.tracks.points_world), 1.3 * before, atol=1e-8)


def test_a_track_that_keeps_denying_the_motion_is_dropped() -> None:
    tracker = driven()
    ids = tracker.tracks.ids[tracker.tracks.located]
    for _ in range(TrackerConfig().max_strikes):
        assert set(ids) <= set(tracker.tracks.ids)
        tracker.judge(~np.isin(tracker.tracks.ids[tracker.tracks.located], ids[:5]))
    assert set(tracker.tracks.ids[tracker.tracks.located]) == set(ids[5:])


def test_a_track_that_agrees_again_is_forgiven() -> None:
    tracker = driven()
    located = int(tracker.tracks.located.sum())
    for agrees in (False, False, True, False, False):
        tracker.judge(np.full(located, agrees))
    assert int(tracker.tracks.located.sum()) == located


def test_a_track_without_a_place_is_not_judged() -> None:
    tracker = started()
    count = len(tracker.tracks)
    for _ in range(TrackerConfig().max_strikes):
        tracker.judge(np.zeros(0, bool))
    assert len(tracker.tracks) == count
