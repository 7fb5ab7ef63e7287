"""What the front end makes of images that cannot be true."""

import numpy as np
import pytest

from estimator.bundle import FrameBundle, Image
from estimator.front_end import FrontEnd, FrontEndConfig
from estimator.se3 import SE3
from estimator.stopwatch import Stopwatch
from tests.bags import small_rig

RIG = small_rig({"front": (96, 64), "left": (96, 64), "rear": (96, 64)})


def front_end(step_m: float) -> FrontEnd:
    """A front end that expects the car to move so far from bundle to bundle."""
    result = FrontEnd(RIG, FrontEndConfig())
    result.odometry._last_step = SE3(np.eye(3), np.array([step_m, 0.0, 0.0]))
    return result


def missed(front: FrontEnd, frozen: str, bundles: int = 4) -> dict[str, int]:
    """Show bundles of noise, one camera always the same, and return what each tracker says it missed."""
    rng = np.random.default_rng(0)

    def noise() -> Image:
        return rng.integers(0, 256, (64, 96), np.uint8)

    still = noise()
    for index in range(bundles):
        images = {name: still if name == frozen else noise() for name in RIG.cameras}
        front.advance(FrameBundle(index, images), Stopwatch())
    return {name: tracker.missed_count for name, tracker in front.trackers.items()}


@pytest.mark.parametrize("frozen", ["front", "rear"])
def test_an_image_that_repeats_while_the_car_moves_counts_as_missing(frozen: str) -> None:
    assert missed(front_end(0.5), frozen) == {name: 3 if name == frozen else 0 for name in RIG.cameras}


def test_a_car_that_stands_may_see_the_same_again() -> None:
    assert missed(front_end(0.0), "rear") == dict.fromkeys(RIG.cameras, 0)


def test_a_camera_that_wakes_up_is_seen_again() -> None:
    front = front_end(0.5)
    missed(front, "rear")
    assert missed(front, "none", bundles=1)["rear"] == 0


def test_tracks_that_wait_are_neither_shown_nor_kept_in_a_keyframe() -> None:
    front = front_end(0.5)
    missed(front, "none", bundles=2)
    images = {name: image for name, image in front.keyframe().images.items() if name != "rear"}
    front.advance(FrameBundle(2, images), Stopwatch())
    assert len(front.trackers["rear"].tracks) > 0
    assert len(front.live_tracks_px()["rear"]) == 0 and "rear" not in front.keyframe().tracks


def test_tracks_on_the_car_itself_are_not_kept_in_a_keyframe() -> None:
    front = front_end(0.5)
    missed(front, "none", bundles=1)
    tracks = front.trackers["left"].tracks
    tracks.on_car[:3] = True
    ids, pixels = front.keyframe().tracks["left"]
    np.testing.assert_array_equal(ids, tracks.ids[3:])
    np.testing.assert_array_equal(pixels, tracks.pixels[3:])
