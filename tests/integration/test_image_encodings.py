"""Images of every encoding become the same grey bundles."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.bag_messages import Frame
from tests.bags import compressed_entries, frames_of, raw_entries, write_bag
from tests.bundles import RIG, assert_bundles, expected, read


def in_colour(frame: Frame, code: int | None = None) -> Frame:
    """Give a frame three channels that differ."""
    colour = np.dstack([frame.pixels, frame.pixels // 2, 255 - frame.pixels])
    return Frame(frame.camera, frame.stamp_ns, colour if code is None else cv2.cvtColor(colour, code))


@pytest.mark.parametrize(
    ("encoding", "from_bgr"),
    [
        ("bgr8", None),
        ("rgb8", cv2.COLOR_BGR2RGB),
        ("bgra8", cv2.COLOR_BGR2BGRA),
        ("rgba8", cv2.COLOR_BGR2RGBA),
    ],
)
def test_colour_becomes_grey(tmp_path: Path, encoding: str, from_bgr: int | None) -> None:
    frames = frames_of(RIG)
    bag = write_bag(tmp_path / "bag", raw_entries([in_colour(each, from_bgr) for each in frames], encoding))
    grey = [
        Frame(each.camera, each.stamp_ns, cv2.cvtColor(in_colour(each).pixels, cv2.COLOR_BGR2GRAY))
        for each in frames
    ]
    assert_bundles(read(bag), grey)


@pytest.mark.parametrize("encoding", ["mono8", "bgr8"])
def test_padded_rows(tmp_path: Path, encoding: str) -> None:
    frames = frames_of(RIG)
    sent = frames if encoding == "mono8" else [in_colour(each) for each in frames]
    plain = read(write_bag(tmp_path / "plain", raw_entries(sent, encoding)))
    padded = read(write_bag(tmp_path / "padded", raw_entries(sent, encoding, padding=5)))
    assert_bundles(
        padded, [Frame(name, each.stamp_ns, image) for each in plain for name, image in each.images.items()]
    )


@pytest.mark.parametrize("big_endian", [False, True])
def test_sixteen_bits_keep_the_high_byte(tmp_path: Path, big_endian: bool) -> None:
    frames = frames_of(RIG)
    kind = ">u2" if big_endian else "<u2"
    deep = [Frame(f.camera, f.stamp_ns, (f.pixels.astype(np.uint16) * 256 + 99).astype(kind)) for f in frames]
    bag = write_bag(tmp_path / "bag", raw_entries(deep, "mono16", big_endian=big_endian))
    assert_bundles(read(bag), frames)


def test_png_is_exact(tmp_path: Path) -> None:
    frames = frames_of(RIG)
    assert_bundles(read(write_bag(tmp_path / "bag", compressed_entries(frames, ".png"))), frames)


def test_jpeg_is_near(tmp_path: Path) -> None:
    smooth = [
        Frame(f.camera, f.stamp_ns, cv2.GaussianBlur(f.pixels, (0, 0), 3)) for f in frames_of(RIG, count=3)
    ]
    bundles = read(write_bag(tmp_path / "bag", compressed_entries(smooth, ".jpg")))
    wanted = expected(smooth)
    for bundle in bundles:
        for name, image in bundle.images.items():
            assert np.abs(image.astype(int) - wanted[bundle.stamp_ns][name]).max() <= 12
