"""What counts as a disagreement between camera_info and the rig."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from estimator.camera import Camera
from estimator.camera_info import camera_info_disagreement
from tests.bag_messages import Frame, info_message

PINHOLE = Camera("pinhole", (48, 32), (50.0, 50.0), (23.5, 15.5))
BROWN = replace(PINHOLE, model="brown_conrady", distortion=(-0.3, 0.1, 0.0, 0.0, 0.0))
FISHEYE = replace(PINHOLE, model="kannala_brandt", distortion=(0.1, 0.0, 0.0, 0.0))
INFO = info_message(Frame("front", 0, np.zeros(0)), PINHOLE)


def test_agreement_is_silent() -> None:
    assert camera_info_disagreement(INFO, PINHOLE) is None
    assert camera_info_disagreement(replace(INFO, d=np.array(BROWN.distortion)), BROWN) is None
    fisheye = replace(INFO, distortion_model="equidistant", d=np.array(FISHEYE.distortion))
    assert camera_info_disagreement(fisheye, FISHEYE) is None


def test_an_uncalibrated_camera_says_nothing() -> None:
    assert camera_info_disagreement(replace(INFO, k=np.zeros(9), width=1), PINHOLE) is None


@pytest.mark.parametrize(
    ("camera", "word"),
    [
        (replace(PINHOLE, size_px=(48, 31)), "size_px"),
        (replace(PINHOLE, focal_px=(50.2, 50.0)), "focal_px"),
        (replace(PINHOLE, center_px=(23.5, 15.0)), "center_px"),
        (BROWN, "distortion"),
        (FISHEYE, "distortion model"),
    ],
)
def test_a_disagreement_names_the_field(camera: Camera, word: str) -> None:
    difference = camera_info_disagreement(INFO, camera)
    assert difference is not None and difference.startswith(word)
