"""Read small bags and compare the bundles with the frames that were written."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from estimator.bundle import FrameBundle
from estimator.recording import Recording
from estimator.rig import Rig
from tests.bag_messages import Frame
from tests.bags import small_rig

RIG = small_rig()


def read(bag: Path, rig: Rig = RIG) -> list[FrameBundle]:
    with Recording(bag, rig) as recording:
        bundles = list(recording.bundles())
        assert recording.warnings == []
    return bundles


def expected(frames: list[Frame]) -> dict[int, dict[str, np.ndarray]]:
    """Return the grey images by stamp and camera."""
    images: dict[int, dict[str, np.ndarray]] = {}
    for frame in frames:
        images.setdefault(frame.stamp_ns, {})[frame.camera] = frame.pixels
    return images


def assert_bundles(bundles: list[FrameBundle], frames: list[Frame]) -> None:
    images = expected(frames)
    assert [bundle.stamp_ns for bundle in bundles] == sorted(images)
    for bundle in bundles:
        assert bundle.images.keys() == images[bundle.stamp_ns].keys()
        for name, image in bundle.images.items():
            assert image.dtype == np.uint8
            np.testing.assert_array_equal(image, images[bundle.stamp_ns][name])
