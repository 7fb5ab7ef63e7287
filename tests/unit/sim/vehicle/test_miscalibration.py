from __future__ import annotations

import numpy as np
import pytest

from estimator.camera import Camera
from estimator.rig import MountedCamera, Rig
from estimator.se3 import SE3
from sim.vehicle.miscalibration import MiscalibrationConfig, miscalibrate

CAMERA = Camera("pinhole", (640, 400), (457.0, 457.0), (319.5, 199.5))
POSE = SE3.exp(np.array([0.1, 0.5, -1.0, 1.0, 0.2, 1.4]))


def rig(*names: str) -> Rig:
    return Rig("front", {name: MountedCamera(CAMERA, POSE) for name in ("front", *names)})


@pytest.mark.parametrize("seed", range(5))
def test_every_camera_but_the_reference_is_off_by_exactly_the_stated_sizes(seed: int) -> None:
    true = miscalibrate(rig("rear", "left"), MiscalibrationConfig(rotation_deg=3, translation_mm=100), seed)
    assert list(true) == ["front", "rear", "left"]
    assert true["front"] is POSE
    for name in ("rear", "left"):
        assert np.degrees((POSE.inverse() @ true[name]).angle_rad) == pytest.approx(3.0, abs=1e-9)
        assert np.linalg.norm(true[name].translation - POSE.translation) == pytest.approx(0.1, abs=1e-12)


def test_a_further_camera_moves_no_other() -> None:
    few = miscalibrate(rig("rear"), MiscalibrationConfig(), 7)
    many = miscalibrate(rig("left", "rear"), MiscalibrationConfig(), 7)
    assert np.array_equal(few["rear"].matrix, many["rear"].matrix)


def test_cameras_and_seeds_differ() -> None:
    one, other = (miscalibrate(rig("rear", "left"), MiscalibrationConfig(), seed) for seed in (1, 2))
    assert not np.allclose(one["rear"].matrix, one["left"].matrix)
    assert not np.allclose(one["rear"].matrix, other["rear"].matrix)


def test_directions_favour_no_axis() -> None:
    shifts = [
        miscalibrate(rig("rear"), MiscalibrationConfig(), seed)["rear"].translation - POSE.translation
        for seed in range(400)
    ]
    assert np.abs(np.mean(shifts, axis=0)).max() < 0.012  # 4 sigma of 0.1 / sqrt(3 * 400)
