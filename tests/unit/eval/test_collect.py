"""What a log keeps, and that it stays small."""

import numpy as np

from estimator.bundle import FrameBundle
from estimator.estimate import Match
from eval.match_pictures import MatchPictureKeeper
from eval.thumbnails import MomentKeeper, TailHistory, thumbnail
from eval.usage import UsageMeter
from tests.unit.eval.tiny_run import RIG, run_log, straight


def test_moments_stay_few_and_spread_over_a_drive_of_any_length():
    keeper, history = MomentKeeper(capacity=6), TailHistory()
    for index in range(1000):
        keeper.offer(FrameBundle(index, {}), {}, history)
    kept = [moment.stamp_ns for moment in keeper.moments]
    assert 3 <= len(kept) <= 6
    assert len(set(np.diff(kept))) == 1
    assert kept[-1] > 500


def test_tails_join_the_steps_of_one_track_and_no_other():
    history = TailHistory(length=3)
    history.add({"a": np.array([[0.0, 0, 1, 1], [5, 5, 6, 6]])})
    history.add({"a": np.array([[1.0, 1, 2, 2]])})
    history.add({"a": np.array([[2.0, 2, 3, 3], [9, 9, 8, 8]])})
    long, short = history.tails("a")
    assert long.tolist() == [[0, 0], [1, 1], [2, 2], [3, 3]]
    assert short.tolist() == [[9, 9], [8, 8]]


def test_a_thumbnail_is_small_and_remembers_the_full_size():
    small = thumbnail(np.zeros((1200, 1920), np.uint8))
    assert small.image.shape == (300, 480)
    assert small.full_size_px == (1920, 1200)


def test_matches_are_counted_by_pair_whichever_camera_comes_first():
    keeper = MatchPictureKeeper(("front", "left"))
    keeper.remember(1, {name: thumbnail(np.zeros((4, 4), np.uint8)) for name in ("front", "left")})
    keeper.offer([Match("left", 1, (1, 2), "front", 1, (3, 4)), Match("front", 1, (5, 6), "left", 1, (7, 8))])
    assert keeper.same_time_counts == {("front", "left"): 2}
    assert [match.pixel_a for match in keeper.pictures["front", "left"].matches] == [(3, 4), (5, 6)]


def test_the_picture_with_most_matches_stays():
    keeper = MatchPictureKeeper(("a", "b"))
    for stamp, count in ((1, 2), (2, 5), (3, 4)):
        keeper.remember(stamp, {name: thumbnail(np.zeros((4, 4), np.uint8)) for name in "ab"})
        keeper.offer([Match("a", stamp, (0, 0), "b", stamp, (1, 1))] * count)
    assert keeper.pictures["a", "b"].stamps_ns == (2, 2)


def test_images_of_old_bundles_are_let_go():
    keeper = MatchPictureKeeper(("a", "b"))
    for stamp in range(300):
        keeper.remember(stamp, {"a": thumbnail(np.zeros((1000, 1000), np.uint8))})
    keeper.offer([Match("a", 0, (0, 0), "b", 299, (1, 1))])
    assert not keeper.pictures
    assert keeper.later_counts == {("a", "b"): 1}


def test_cpu_time_counts_inside_the_estimator_only():
    meter = UsageMeter()
    sum(range(3_000_000))
    outside = meter.cpu_s
    with meter.measuring():
        sum(range(3_000_000))
    assert outside < 0.01
    assert meter.cpu_s > 0.01
    assert meter.peak_rss_mb > 10


def test_a_log_keeps_one_entry_a_bundle():
    log = run_log(straight(4))
    assert len(log.entries) == 4
    assert set(log.entries[0].cameras) == set(RIG.cameras)


def test_matches_that_link_no_two_cameras_of_the_rig_are_left_out():
    keeper = MatchPictureKeeper(("a", "b"))
    keeper.offer([Match("a", 0, (0, 0), "a", 9, (1, 1)), Match("a", 0, (0, 0), "unknown", 0, (1, 1))])
    assert not keeper.same_time_counts and not keeper.later_counts
