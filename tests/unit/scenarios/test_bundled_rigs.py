from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from estimator.rig_file import read_rig
from sim.vehicle.miscalibration import MiscalibrationConfig, miscalibrate
from tests.unit.scenarios.test_gap_rig import shared_columns

RIGS = Path(__file__).parents[3] / "scenarios" / "rigs"
OVERLAP, FISHEYE = (read_rig(RIGS / f"{name}.yaml") for name in ("overlap", "fisheye"))
SIDES = [("left_front", "left_rear"), ("right_front", "right_rear")]


@pytest.mark.parametrize(("front", "rear"), SIDES)
@pytest.mark.parametrize("seed", range(4))
def test_side_cameras_of_the_overlap_rig_share_a_little(front: str, rear: str, seed: int) -> None:
    rig = OVERLAP.with_extrinsics(miscalibrate(OVERLAP, MiscalibrationConfig(), seed))
    assert 0.03 < shared_columns(rig, front, rear) < 0.35


@pytest.mark.parametrize(
    ("one", "other"),
    [
        *[("front", side) for side in ("left_front", "right_front")],
        *[("rear", side) for side in ("left_rear", "right_rear")],
    ],
)
def test_neighbours_of_the_overlap_rig_share_a_good_part(one: str, other: str) -> None:
    assert shared_columns(OVERLAP, one, other) > 0.2


def test_five_cameras_of_the_fisheye_rig_see_more_than_a_half_plane() -> None:
    wide = 0
    for mounted in FISHEYE.cameras.values():
        edges = np.array([[0.0, 200.0], [639.0, 200.0]])
        wide += bool((mounted.camera.unproject(edges)[:, 2] < 0).all())
    assert wide == 5


@pytest.mark.parametrize("name", ["left_front", "rear"])
def test_a_fisheye_projects_what_it_unprojects_beyond_90_deg(name: str) -> None:
    camera = FISHEYE[name].camera
    columns, rows = np.meshgrid(np.linspace(0, 639, 41), np.linspace(0, 399, 31))
    pixels = np.column_stack([columns.ravel(), rows.ravel()])
    rays = camera.unproject(pixels)
    assert rays[:, 2].min() < -0.3
    again, jacobian = camera.project_with_jacobian(7 * rays)
    assert np.abs(again - pixels).max() < 1e-9
    step = 1e-6 * np.array([0.3, -0.5, 0.8])
    assert np.allclose((camera.project(7 * rays + step) - again), jacobian @ step, atol=1e-9)
