"""The grid that learns where the car itself is in an image, and forgets what it had wrong."""

from __future__ import annotations

import numpy as np

from estimator.own_car_mask import OwnCarConfig, OwnCarMask
from estimator.se3 import Array
from estimator.track_table import TrackTable
from tests.mounts import PINHOLE, arc, left_side_rig

FRONT = left_side_rig()["front"].ego_from_cam
CONFIG = OwnCarConfig()
STEP_M = 0.5
PATH = arc(STEP_M, 9, 0.0)
BONNET = np.array([[160.5, 180.5]])
CELL = 11, 10


def starting(pixels: Array) -> TrackTable:
    tracks = TrackTable()
    tracks.start(pixels, PINHOLE.unproject(pixels))
    tracks.anchor(PATH[0] @ FRONT)
    return tracks


def drive(mask: OwnCarMask, pixels: Array, flow_px: float = 0.0) -> TrackTable:
    """Drive 4 m past tracks that move down by so much each step; return those that are left."""
    tracks = starting(pixels)
    for pose in PATH[1:]:
        tracks.pixels = tracks.pixels + np.array([0.0, flow_px])
        tracks.keep(mask.see(tracks, 180.0, pose, FRONT, STEP_M))
    return tracks


def learnt(pixels: Array = BONNET) -> OwnCarMask:
    mask = OwnCarMask(PINHOLE.size_px, CONFIG)
    drive(mask, pixels)
    return mask


def test_where_a_track_stands_still_no_new_one_may_start() -> None:
    usable_px = learnt().usable_px(200, 320)
    assert usable_px is not None and usable_px.shape == (200, 320)
    assert not usable_px[180, 160] and usable_px[100, 160]


def test_an_image_of_another_size_is_not_barred() -> None:
    assert learnt().usable_px(480, 640) is None


def test_the_track_is_given_up_once_it_is_told() -> None:
    assert len(drive(OwnCarMask(PINHOLE.size_px, CONFIG), BONNET)) == 0


def test_it_is_marked_as_the_car_s_long_before() -> None:
    tracks = starting(np.vstack([BONNET, [[160.5, 20.5]]]))
    OwnCarMask(PINHOLE.size_px, CONFIG).see(tracks, 180.0, PATH[2], FRONT, 2 * STEP_M)
    np.testing.assert_array_equal(tracks.on_car, [True, False])


def test_cells_beside_it_are_barred_until_something_moves_there() -> None:
    mask = learnt()
    beside = CELL[0] - 1, CELL[1]
    assert mask.barred[beside]
    drive(mask, BONNET - [0.0, 24.0], 1.0)
    assert not mask.barred[beside] and mask.barred[CELL]


def test_a_street_that_moved_there_for_long_outweighs_one_thing_that_stands() -> None:
    mask = OwnCarMask(PINHOLE.size_px, CONFIG)
    for _ in range(3):
        drive(mask, np.repeat(BONNET - [0.0, 6.0], 3, axis=0), 1.0)
    drive(mask, BONNET)
    assert not mask.barred.any()


def test_a_cell_wrongly_barred_comes_free_when_tracks_move_through_it() -> None:
    mask = learnt()
    drive(mask, np.repeat(BONNET - [0.0, 6.0], 3, axis=0), 1.0)
    assert not mask.barred[CELL]


def test_a_barred_cell_gets_another_chance_and_comes_free_without_new_evidence() -> None:
    mask = learnt()
    nobody = np.zeros((0, 2))
    opened = []
    for _ in range(8):
        drive(mask, nobody)
        opened.append(bool(mask.usable[CELL]))
    assert any(opened) and not mask.barred.any()


def test_few_barred_cells_are_open_at_a_time() -> None:
    mask = learnt(np.column_stack([np.arange(8.5, 320, 16), np.full(20, 180.5)]))
    for _ in range(5):
        drive(mask, np.zeros((0, 2)))
        assert np.sum(mask.usable & mask.barred) <= CONFIG.probes < mask.barred.sum()


def test_an_image_that_stands_still_all_over_bars_nothing() -> None:
    pixels = np.stack(np.meshgrid(np.arange(8.5, 320, 16), np.arange(8.5, 200, 16)), -1).reshape(-1, 2)
    mask = OwnCarMask(PINHOLE.size_px, CONFIG)
    turning = arc(STEP_M, 9, 1 / 30)
    tracks = starting(pixels)
    for pose in turning[1:]:
        tracks.keep(mask.see(tracks, 180.0, pose, FRONT, STEP_M))
    assert len(tracks) < 30 and not mask.barred.any() and mask.usable_px(200, 320) is None
