"""Drives with a patterned bonnet in view: no renderer, exact truth."""

from __future__ import annotations

import numpy as np
import pytest

from estimator.bundle import FrameBundle, Image
from estimator.estimate import Estimate, Status
from estimator.online import OnlineEstimator
from tests.canyon import noise_image
from tests.canyon_drive import IN_STEP, NOMINAL, PATH, TRUTH, rig_of
from tests.mounts import worst_error

TOP_PX = 144
BONNET = noise_image(200, 320, 77)


def with_bonnet(image: Image) -> Image:
    return np.vstack([image[:TOP_PX], BONNET[TOP_PX:]])


def driven(bundles: list[FrameBundle], names: set[str]) -> list[Estimate]:
    """Return the answers where cameras of those names see the bonnet."""
    estimator = OnlineEstimator(NOMINAL, IN_STEP)
    images = ({n: with_bonnet(i) if n in names else i for n, i in b.images.items()} for b in bundles)
    seen = [FrameBundle(b.stamp_ns, each) for b, each in zip(bundles, images, strict=True)]
    return [*(estimator.update(bundle) for bundle in seen), estimator.close()]


@pytest.fixture(scope="module")
def answers(bundles: list[FrameBundle]) -> list[Estimate]:
    return driven(bundles, {"left_front"})


def on_bonnet(answer: Estimate) -> float:
    return float(np.mean(answer.tracks_px["left_front"][:, 3] > TOP_PX))


def test_after_ten_metres_hardly_a_track_is_spent_on_the_car(answers: list[Estimate]) -> None:
    driven_m = np.linalg.norm([pose.translation for pose in PATH], axis=1)
    shares = [on_bonnet(a) for a, m in zip(answers, driven_m, strict=False) if m > 10]
    assert on_bonnet(answers[1]) > 0.2 and len(shares) > 3 and max(shares) < 0.06


def test_the_camera_that_sees_the_bonnet_converges(answers: list[Estimate]) -> None:
    assert answers[-1].cameras["left_front"].status is Status.CONVERGED
    rotation_deg, translation_mm = worst_error(rig_of(answers[-1]), TRUTH)
    assert rotation_deg < 0.2 and translation_mm < 40
