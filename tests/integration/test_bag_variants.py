"""Recordings in every variety give the same bundles."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from rosbags.rosbag2 import CompressionMode

from estimator.recording import Recording
from eval.truth import read_truth
from tests.bag_messages import NS, Frame, info_message
from tests.bags import (
    OPTICAL,
    Entry,
    frames_of,
    raw_entries,
    truth_entries,
    write_bag,
)
from tests.bundles import RIG, assert_bundles, expected, read

EPOCH_NS = 1_760_000_000 * NS + 123_456_789


@pytest.mark.parametrize("start_ns", [0, NS, EPOCH_NS])
@pytest.mark.parametrize("rate_hz", [5.0, 30.0])
def test_any_start_and_rate(tmp_path: Path, start_ns: int, rate_hz: float) -> None:
    frames = frames_of(RIG, start_ns=start_ns, rate_hz=rate_hz)
    assert_bundles(read(write_bag(tmp_path / "bag", raw_entries(frames))), frames)


def test_the_file_itself_and_a_folder_without_metadata(tmp_path: Path) -> None:
    frames = frames_of(RIG)
    bag = write_bag(tmp_path / "bag", raw_entries(frames))
    assert_bundles(read(next(bag.glob("*.mcap"))), frames)
    (bag / "metadata.yaml").unlink()
    assert_bundles(read(bag), frames)


def test_sqlite_storage(tmp_path: Path) -> None:
    frames = frames_of(RIG)
    assert_bundles(read(write_bag(tmp_path / "bag", raw_entries(frames), storage="sqlite3")), frames)


@pytest.mark.parametrize("compression", [CompressionMode.NONE, CompressionMode.FILE, CompressionMode.MESSAGE])
def test_other_compressions(tmp_path: Path, compression: CompressionMode) -> None:
    frames = frames_of(RIG)
    assert_bundles(read(write_bag(tmp_path / "bag", raw_entries(frames), compression=compression)), frames)


def test_a_recording_split_into_files_is_read_in_their_order(tmp_path: Path) -> None:
    frames = frames_of(RIG, count=20)
    (tmp_path / "split").mkdir()
    for number, part in ((2, frames[:31]), (10, frames[31:])):  # the cut goes through a bundle
        bag = write_bag(tmp_path / f"part{number}", raw_entries(part))
        next(bag.glob("*.mcap")).rename(tmp_path / "split" / f"drive_{number}.mcap")
    assert_bundles(read(tmp_path / "split"), frames)


@pytest.mark.parametrize("seed", [0, 1])
def test_shuffled_topics(tmp_path: Path, seed: int) -> None:
    frames = frames_of(RIG)
    by_instant = [frames[i : i + len(RIG.cameras)] for i in range(0, len(frames), len(RIG.cameras))]
    for instant in by_instant:
        random.Random(seed).shuffle(instant)
    shuffled = [frame for instant in by_instant for frame in instant]
    assert_bundles(read(write_bag(tmp_path / "bag", raw_entries(shuffled))), frames)


def test_topic_after_topic(tmp_path: Path) -> None:
    frames = frames_of(RIG)
    in_blocks = sorted(frames, key=lambda frame: frame.camera, reverse=True)
    assert_bundles(read(write_bag(tmp_path / "bag", raw_entries(in_blocks))), frames)


def test_one_camera_arrives_late(tmp_path: Path) -> None:
    delayed = [
        Frame(each.camera, each.stamp_ns, each.pixels, each.stamp_ns + (each.camera == "front") * 350_000_000)
        for each in frames_of(RIG, count=12)
    ]
    in_order = sorted(delayed, key=lambda frame: frame.log_ns or 0)
    assert_bundles(read(write_bag(tmp_path / "bag", raw_entries(in_order))), delayed)


@pytest.mark.parametrize("rate_hz", [5.0, 10.0, 30.0])
def test_jittered_stamps_are_one_bundle_with_the_reference_stamp(tmp_path: Path, rate_hz: float) -> None:
    frames = frames_of(RIG, count=15, rate_hz=rate_hz, jitter_ns=round(0.12 * NS / rate_hz))
    bundles = read(write_bag(tmp_path / "bag", raw_entries(frames)))
    assert [set(bundle.images) for bundle in bundles] == [set(RIG.cameras)] * 15
    assert [bundle.stamp_ns for bundle in bundles] == [f.stamp_ns for f in frames if f.camera == "front"]


def test_a_missing_image_is_an_absent_key(tmp_path: Path) -> None:
    lost = {("rear", 2), ("front", 4), ("left", 0)}
    frames = frames_of(RIG, skip=lambda camera, index: (camera, index) in lost)
    bundles = read(write_bag(tmp_path / "bag", raw_entries(frames)))
    assert_bundles(bundles, frames)
    assert [len(bundle.images) for bundle in bundles] == [2, 3, 2, 3, 2, 3]


def test_a_camera_that_dies_does_not_stop_the_others(tmp_path: Path) -> None:
    frames = frames_of(RIG, count=40, skip=lambda camera, index: camera == "rear" and index > 1)
    assert_bundles(read(write_bag(tmp_path / "bag", raw_entries(frames))), frames)


def test_truth_is_not_looked_at(tmp_path: Path) -> None:
    frames = frames_of(RIG)
    truth = truth_entries(dict.fromkeys(RIG.cameras, OPTICAL), sorted(expected(frames)))
    entries = sorted([*truth, *raw_entries(frames)], key=lambda entry: entry.log_ns)
    with_truth = write_bag(tmp_path / "with", entries)
    without = write_bag(tmp_path / "without", raw_entries(frames))
    assert_bundles(read(with_truth), frames)
    assert_bundles(read(without), frames)
    assert read_truth(with_truth) is not None
    assert read_truth(without) is None


def test_camera_info_that_disagrees_is_one_warning_for_a_camera(tmp_path: Path) -> None:
    frames = frames_of(RIG)
    entries = raw_entries(frames)
    for frame in frames:
        focal_px = 51.0 if frame.camera == "left" else None
        info = info_message(frame, RIG[frame.camera].camera, focal_px)
        entries.append(Entry(f"/{frame.camera}/camera_info", info, frame.stamp_ns))
    with Recording(write_bag(tmp_path / "bag", entries), RIG) as recording:
        assert len(list(recording.bundles())) == 6
    assert len(recording.warnings) == 1
    assert "'left'" in recording.warnings[0] and "51.0" in recording.warnings[0]


def test_a_second_reading_gives_the_same(tmp_path: Path) -> None:
    frames = frames_of(RIG)
    with Recording(write_bag(tmp_path / "bag", raw_entries(frames)), RIG) as recording:
        assert recording.bundle_count == 6
        assert_bundles(list(recording.bundles()), frames)
        assert_bundles(list(recording.bundles()), frames)
