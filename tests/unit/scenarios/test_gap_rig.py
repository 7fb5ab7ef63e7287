from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from estimator.rig import Rig
from estimator.rig_file import read_rig
from sim.vehicle.miscalibration import MiscalibrationConfig, miscalibrate

RIG = read_rig(Path(__file__).parents[3] / "scenarios" / "rigs" / "gap.yaml")
DEPTHS_M = (1.0, 2.0, 4.0, 8.0, 16.0, 40.0, 100.0)
FRONT = ("front", "front_right", "left_front", "right_front")
REAR = ("left_rear", "right_rear", "rear")


def shared_columns(rig: Rig, one: str, other: str) -> float:
    """Return the share of one camera's columns in which the other sees something, at any of the depths."""
    camera = rig[one].camera
    width, height = camera.size_px
    pixels = np.stack(np.meshgrid(np.linspace(0, width - 1, 65), np.linspace(0, height - 1, 41)), -1)
    rays = camera.unproject(pixels.reshape(-1, 2))
    other_from_one = rig[other].ego_from_cam.inverse() @ rig[one].ego_from_cam
    seen = [
        rig[other].camera.contains(rig[other].camera.project(other_from_one.apply(rays * depth_m)))
        for depth_m in DEPTHS_M
    ]
    return float(np.any(seen, axis=0).reshape(41, 65).any(axis=0).mean())


@pytest.mark.parametrize("seed", range(8))
def test_front_and_rear_share_nothing_however_the_cameras_are_off(seed: int) -> None:
    rig = RIG.with_extrinsics(miscalibrate(RIG, MiscalibrationConfig(), seed))
    assert not any(shared_columns(rig, one, other) for one in FRONT for other in REAR)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        *[(front, side) for front in ("front", "front_right") for side in ("left_front", "right_front")],
        *[("rear", side) for side in ("left_rear", "right_rear")],
    ],
)
def test_neighbours_share_a_good_part_of_their_view(one: str, other: str) -> None:
    assert shared_columns(RIG, one, other) > 0.2


def test_both_distortion_models_are_there() -> None:
    models = [mounted.camera.model for mounted in RIG.cameras.values()]
    assert models.count("brown_conrady") == 2
    assert models.count("kannala_brandt") == 1
