"""Tracks beside the truth: a camera that moves along a wall, without and with something stuck to its lens."""

import cv2
import numpy as np
import pytest

from estimator.bundle import Image
from estimator.camera import Camera
from estimator.se3 import SE3
from eval.likeness_statistics import statistics_of
from tests.benchmark.ladder_rides import Ride
from tests.benchmark.true_tracks import shift_px, true_shares

SIZE_PX, STEP_PX, WALL_M, FOCAL_PX = (240, 160), 4, 5.0, 200.0
WINDOW = (slice(20, 140), slice(0, 240))
FRAMES = 12


def texture(seed: int, size_px: tuple[int, int]) -> Image:
    noise = np.random.default_rng(seed).uniform(0, 255, (size_px[1] // 6 + 1, size_px[0] // 6 + 1))
    return np.asarray(cv2.resize(noise, size_px, interpolation=cv2.INTER_CUBIC).clip(0, 255), np.uint8)


def along_a_wall(stuck: slice | None = None, shift: int = 0) -> Ride:
    """Return a ride past a wall; columns of ``stuck`` show the same in every frame."""
    wall = texture(1, (SIZE_PX[0] + FRAMES * STEP_PX + 20, SIZE_PX[1]))
    frames = [wall[:, shift + STEP_PX * k : shift + STEP_PX * k + SIZE_PX[0]].copy() for k in range(FRAMES)]
    for frame in frames if stuck else ():
        frame[:, stuck] = texture(2, SIZE_PX)[:, stuck]
    pinhole = Camera("pinhole", SIZE_PX, (FOCAL_PX, FOCAL_PX), (119.5, 79.5))
    poses = [SE3(np.eye(3), np.array([STEP_PX * WALL_M / FOCAL_PX * k, 0.0, 0.0])) for k in range(FRAMES)]
    depth_m = np.full(SIZE_PX[::-1], WALL_M, np.float32)
    return Ride(frames, pinhole, poses, {0: depth_m, 3: depth_m})


def test_tracks_of_a_wall_are_true_until_they_leave_the_image() -> None:
    shares = true_shares(along_a_wall(), WINDOW)
    assert shares["true_share_1"] > 0.8  # a tenth lies at the rim
    assert 0.7 < shares["true_share_5"] < shares["true_share_1"]


def test_what_sticks_to_the_lens_survives_but_is_not_true() -> None:
    ride = along_a_wall(stuck=slice(120, 240))
    shares = true_shares(ride, WINDOW)
    survivals = statistics_of([frame[WINDOW] for frame in ride.frames])
    assert survivals["klt_survival_5"].mean() > 0.7
    assert shares["true_share_5"] < 0.5


def test_without_a_corner_nothing_is_true() -> None:
    ride = along_a_wall()
    blank = Ride([np.full_like(f, 9) for f in ride.frames], ride.pinhole, ride.world_from_cams, ride.depths_m)
    assert true_shares(blank, WINDOW) == {"true_share_1": 0.0, "true_share_5": 0.0}
    assert shift_px(blank, blank, WINDOW) == 0.0


def test_corners_are_shifted_as_far_as_the_image_is() -> None:
    assert shift_px(along_a_wall(), along_a_wall(shift=3), WINDOW) == pytest.approx(3.0, abs=0.1)
