"""What is wrong with a recording is told in one line; a broken one is used up to its break."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from mcap.writer import Writer as McapWriter
from rosbags.rosbag2 import CompressionMode

from estimator.errors import InputError
from estimator.recording import Recording
from estimator.rig import Rig
from eval.truth import read_truth
from tests.bag_messages import NS, Frame
from tests.bags import (
    OPTICAL,
    cut,
    frames_of,
    raw_entries,
    small_rig,
    truth_entries,
    write_bag,
)

RIG = small_rig()
WIDE_RIG = small_rig({"front": (320, 240), "rear": (320, 240)})


def refusal(bag: Path, rig: Rig = RIG) -> str:
    """Return the one line with which a recording is refused before any bundle is asked for."""
    with pytest.raises(InputError) as caught, Recording(bag, rig):
        pass
    text = str(caught.value)
    assert "\n" not in text
    assert str(bag) in text
    return text


def test_a_missing_path(tmp_path: Path) -> None:
    assert "no such recording" in refusal(tmp_path / "nothing")


def test_an_empty_folder(tmp_path: Path) -> None:
    assert "wanted a ROS 2 bag" in refusal(tmp_path)


@pytest.mark.parametrize("content", [b"", b"hello\n", b"#ROSBAG V2.0\n", b"\x89PNG\r\n\x1a\n" * 9])
@pytest.mark.parametrize("suffix", [".mcap", ".bag", ".txt", ".db3"])
def test_a_file_of_another_type(tmp_path: Path, content: bytes, suffix: str) -> None:
    file = tmp_path / f"file{suffix}"
    file.write_bytes(content)
    assert "wanted a ROS 2 bag" in refusal(file)


def test_metadata_alone(tmp_path: Path) -> None:
    bag = write_bag(tmp_path / "bag", raw_entries(frames_of(RIG)))
    next(bag.glob("*.mcap")).unlink()
    assert "metadata.yaml without a recording" in refusal(bag)


def test_a_bag_without_images(tmp_path: Path) -> None:
    bag = write_bag(tmp_path / "bag", truth_entries({"front": OPTICAL}, [0, NS]))
    assert "no images" in refusal(bag)


def test_an_image_topic_of_another_type(tmp_path: Path) -> None:
    entries = raw_entries(frames_of(RIG))
    other = truth_entries({}, [0])[1]
    bag = write_bag(tmp_path / "bag", [replace(other, topic="/front/image_raw"), *entries[1:2]])
    assert "got nav_msgs/msg/Odometry, wanted sensor_msgs/msg/Image" in refusal(bag)


@pytest.mark.parametrize("names", [("front", "left"), ("front", "left", "rear", "roof"), ("front", "back")])
def test_cameras_of_bag_and_rig_differ(tmp_path: Path, names: tuple[str, ...]) -> None:
    in_bag = small_rig(dict.fromkeys(names, (48, 32)))
    text = refusal(write_bag(tmp_path / "bag", raw_entries(frames_of(in_bag))))
    for name in set(names) ^ set(RIG.cameras):
        assert name in text
    assert f"cameras of the recording: {', '.join(sorted(names))}" in text
    assert "cameras of the rig: front, left, rear" in text


def test_images_of_another_size(tmp_path: Path) -> None:
    other = small_rig({"front": (48, 32), "left": (64, 24), "rear": (48, 32)})
    text = refusal(write_bag(tmp_path / "bag", raw_entries(frames_of(other))))
    assert "/left/image_raw" in text and "64 x 24" in text and "40 x 24" in text


def test_images_that_change_their_size_later(tmp_path: Path) -> None:
    frames = frames_of(RIG, count=20)
    frames[-1] = Frame("rear", frames[-1].stamp_ns, np.zeros((5, 5), np.uint8))
    bag = write_bag(tmp_path / "bag", raw_entries(frames))
    wrong = pytest.raises(InputError, match="/rear/image_raw: got images of 5 x 5")
    with Recording(bag, RIG) as recording, wrong:
        list(recording.bundles())


def test_an_unknown_encoding(tmp_path: Path) -> None:
    text = refusal(write_bag(tmp_path / "bag", raw_entries(frames_of(RIG), "bayer_xyz")))
    assert "'bayer_xyz'" in text and "mono8" in text


def test_an_image_with_too_few_bytes(tmp_path: Path) -> None:
    entries = raw_entries(frames_of(RIG))
    for entry in entries:
        entry.message = replace(entry.message, data=entry.message.data[:100])
    assert "got 100 bytes" in refusal(write_bag(tmp_path / "bag", entries))


def test_one_damaged_image_is_left_out_with_a_warning(tmp_path: Path) -> None:
    entries = raw_entries(frames_of(RIG))
    entries[7].message = replace(entries[7].message, data=entries[7].message.data[:100])
    with Recording(write_bag(tmp_path / "bag", entries), RIG) as recording:
        bundles = list(recording.bundles())
    assert [len(bundle.images) for bundle in bundles] == [3, 3, 2, 3, 3, 3]
    assert recording.warnings == ["camera 'left': 1 image cannot be decoded, left out"]


@pytest.fixture(scope="module")
def long_bag(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a bag of several chunks with truth: 40 bundles of two cameras."""
    frames = frames_of(WIDE_RIG, count=40)
    truth = truth_entries(dict.fromkeys(WIDE_RIG.cameras, OPTICAL), sorted({f.stamp_ns for f in frames}))
    entries = sorted([*truth, *raw_entries(frames)], key=lambda entry: entry.log_ns)
    return write_bag(tmp_path_factory.mktemp("long") / "bag", entries)


@pytest.mark.parametrize("keep_metadata", [False, True])
@pytest.mark.parametrize("share", [0.4, 0.75, 0.999])
def test_a_truncated_bag_is_used_up_to_the_break(
    tmp_path: Path, long_bag: Path, share: float, keep_metadata: bool
) -> None:
    broken = cut(long_bag, tmp_path / "cut", share, keep_metadata=keep_metadata)
    with Recording(long_bag, WIDE_RIG) as recording:
        whole = list(recording.bundles())
    with Recording(broken, WIDE_RIG) as recording:
        told = list(recording.warnings)
        bundles = list(recording.bundles())
        assert recording.bundle_count == len(bundles)
    assert 40 * share - 8 <= len(bundles) <= 40 * share + 1
    for before, after in zip(whole, bundles[:-1], strict=False):
        assert before.stamp_ns == after.stamp_ns
        for name in before.images:
            np.testing.assert_array_equal(before.images[name], after.images[name])
    assert told == recording.warnings
    assert len(told) == 1
    assert "truncated" in told[0] and f"used {len(bundles)} bundles" in told[0]
    truth = read_truth(broken)
    assert truth is not None and 0 < len(truth.stamps_ns) <= 40


def test_a_bag_cut_before_the_first_chunk_ends_is_refused(tmp_path: Path, long_bag: Path) -> None:
    assert "truncated" in refusal(cut(long_bag, tmp_path / "cut", 0.02), WIDE_RIG)


def test_a_bag_with_a_damaged_chunk_is_used_up_to_it(tmp_path: Path, long_bag: Path) -> None:
    broken = cut(long_bag, tmp_path / "damaged", 1.0, keep_metadata=True)
    file = next(broken.glob("*.mcap"))
    data = bytearray(file.read_bytes())
    middle = data.index(b"zstd", len(data) // 2)
    data[middle + 12 : middle + 20] = b"\0" * 8  # the magic number of the compressed chunk
    file.write_bytes(data)
    with Recording(broken, WIDE_RIG) as recording:
        bundles = list(recording.bundles())
    assert 10 <= len(bundles) <= 30
    assert len(recording.warnings) == 1
    assert "damaged" in recording.warnings[0] and f"used {len(bundles)} bundles" in recording.warnings[0]


@pytest.mark.parametrize("compression", [CompressionMode.STORAGE, CompressionMode.NONE])
@pytest.mark.parametrize("keep_metadata", [False, True])
@pytest.mark.parametrize("hole_bytes", [1, 5000, 300_000])
def test_a_bag_with_a_hole_and_an_intact_end_is_used_up_to_the_hole(
    tmp_path: Path, hole_bytes: int, keep_metadata: bool, compression: CompressionMode
) -> None:
    entries = raw_entries(frames_of(WIDE_RIG, count=40))
    whole = write_bag(tmp_path / "whole", entries, compression=compression)
    broken = cut(whole, tmp_path / "hole", 1.0, keep_metadata=keep_metadata)
    file = next(broken.glob("*.mcap"))
    data = file.read_bytes()
    file.write_bytes(data[: len(data) // 3] + data[len(data) // 3 + hole_bytes :])
    with Recording(whole, WIDE_RIG) as recording:
        expected = list(recording.bundles())
    with Recording(broken, WIDE_RIG) as recording:
        bundles = list(recording.bundles())
    assert 5 <= len(bundles) <= 14
    assert len(recording.warnings) == 1
    assert "damaged" in recording.warnings[0] and f"used {len(bundles)} bundles" in recording.warnings[0]
    for before, after in zip(expected, bundles, strict=False):
        for name, image in after.images.items():
            np.testing.assert_array_equal(image, before.images[name])


def test_a_whole_mcap_file_that_is_no_bag(tmp_path: Path) -> None:
    with (tmp_path / "other.mcap").open("wb") as stream:
        writer = McapWriter(stream)
        writer.start("some profile", "some library")
        writer.finish()
    assert "no ROS 2 bag" in refusal(tmp_path / "other.mcap")
