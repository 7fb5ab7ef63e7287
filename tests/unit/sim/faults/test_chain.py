"""Faults of one drive do not disturb each other, and wrong ones are refused."""

import numpy as np
import pytest

from estimator.errors import InputError
from sim.faults.chain import check_cameras
from sim.faults.transport_faults import Dropped
from tests.unit.sim.faults.test_kinds import CAMERAS, drive, of

DROPPED = {"kind": "dropped", "camera": "rear", "probability": 0.4}


def arrived(*faults: dict[str, object], camera: str = "rear", seed: int = 0) -> list[bool]:
    return [bool(of(camera, bundle)) for bundle in drive(*faults, seed=seed)]


def test_the_same_seed_drops_the_same_frames_and_another_others() -> None:
    assert arrived(DROPPED) == arrived(DROPPED)
    assert arrived(DROPPED) != arrived(DROPPED, seed=1)


def test_another_fault_changes_nothing_about_which_frames_are_dropped() -> None:
    others = (
        {"kind": "jitter", "camera": "all"},
        {"kind": "black", "camera": "rear", "probability": 0.5},
        {"kind": "late", "camera": "rear"},
    )
    assert arrived(*others, DROPPED) == arrived(DROPPED) == arrived(DROPPED, *others[::-1])


def test_a_higher_probability_drops_the_same_frames_and_more() -> None:
    fewer, more = arrived(DROPPED), arrived(DROPPED | {"probability": 0.6})
    assert all(before or not after for before, after in zip(fewer, more, strict=True))
    assert sum(more) < sum(fewer)


def test_cameras_are_drawn_each_for_itself() -> None:
    both = DROPPED | {"camera": "all"}
    assert arrived(both) == arrived(DROPPED)
    assert arrived(both, camera="left") != arrived(both)


def test_the_order_in_the_list_does_not_matter() -> None:
    faults = ({"kind": "swapped", "camera": ["left", "rear"]}, {"kind": "black", "camera": "rear"})
    for one, other in zip(drive(*faults), drive(*faults[::-1]), strict=True):
        assert not of("left", one)[0].image.any()  # black at the camera, then on the other's cable
        assert all(np.array_equal(of(name, one)[0].image, of(name, other)[0].image) for name in CAMERAS)


def test_a_camera_that_is_not_there_is_refused_with_its_path() -> None:
    faults = [Dropped(kind="dropped", camera="left"), Dropped(kind="dropped", camera=["rear", "reer"])]
    with pytest.raises(InputError, match=r"faults\[1\]\.camera: got 'reer', .* front, left, rear, or all"):
        check_cameras(faults, CAMERAS)
