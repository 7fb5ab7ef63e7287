"""Tracks that keep their pixel: the car's own, or merely far away."""

from __future__ import annotations

import numpy as np

from estimator.se3 import SE3, Array
from estimator.still_tracks import StillConfig, not_of_the_street
from estimator.track_table import TrackTable
from tests.canyon import cast
from tests.mounts import PINHOLE, arc, left_side_rig

FRONT = left_side_rig()["front"].ego_from_cam
AHEAD = PINHOLE.project((FRONT.inverse().rotation @ np.array([1.0, 0.0, 0.0]))[None])[0]
BONNET, SKY = np.array([160.5, 180.5]), np.array([60.5, 10.5])


def told(pixels: Array, path: tuple[SE3, ...], then: Array | None = None) -> bool:
    """Tell whether a track that began at a pixel, and is ``then`` elsewhere, is taken for the car's."""
    tracks = TrackTable()
    tracks.start(pixels[None], PINHOLE.unproject(pixels[None]))
    tracks.anchor(path[0] @ FRONT)
    if then is not None:
        tracks.pixels, tracks.rays_cam = then[None], PINHOLE.unproject(then[None])
    return bool(not_of_the_street(tracks, 180.0, path[-1], FRONT, StillConfig())[0])


def test_what_stands_where_the_road_should_pass_is_the_car_s() -> None:
    assert told(BONNET, arc(0.5, 5, 0.0))


def test_the_road_itself_is_not() -> None:
    path = arc(0.5, 5, 0.0)
    where = cast(path[0] @ FRONT, PINHOLE.unproject(np.array([[160.5, 130.5]])))[0]
    then = PINHOLE.project((path[-1] @ FRONT).inverse().apply(where))[0]
    assert not told(np.array([160.5, 130.5]), path, then)


def test_a_car_that_stands_tells_nothing() -> None:
    assert not told(BONNET, (SE3(), SE3()))


def test_what_is_straight_ahead_hardly_moves_and_is_not_the_car_s() -> None:
    assert not told(AHEAD, arc(0.5, 7, 0.0))


def test_the_sky_stands_still_while_the_car_drives_straight() -> None:
    assert not told(SKY, arc(0.5, 7, 0.0))


def test_what_does_not_turn_with_the_car_is_the_car_s_wherever_it_is() -> None:
    turning = arc(0.5, 7, 1 / 30)
    assert told(SKY, turning) and told(AHEAD, turning)


def test_a_near_point_whose_passing_makes_up_for_the_turn_is_not_the_car_s() -> None:
    right = np.array([260.5, 60.5])  # straight on, it would pass to the right; turning right brings it back
    kept = [told(right, arc(0.5, 7, -curvature)) for curvature in (0.004, 0.01, 0.02)]
    assert not any(kept) and told(right, arc(0.5, 7, 0.05))
