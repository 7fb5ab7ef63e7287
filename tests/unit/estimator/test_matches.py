"""Matches between cameras, picked for people to look at."""

from __future__ import annotations

import numpy as np

from estimator.matches import cross_camera_matches
from estimator.observations import Observations

NAMES = ["front", "left", "rear"]
STAMPS_NS = [100, 200, 300]


def seen(*rows: tuple[int, int, int, bool]) -> Observations:
    """Return sightings of (landmark, camera, keyframe, handed over); the pixel is the row's number."""
    landmark, camera, keyframe, handed_over = (np.array(column) for column in zip(*rows, strict=True))
    pixels = np.repeat(np.arange(len(rows), dtype=float)[:, None], 2, 1)
    return Observations(landmark, camera, keyframe, pixels, np.ones(len(rows)), handed_over.astype(bool))


def test_a_match_names_owner_and_guest_with_stamps_and_pixels() -> None:
    (match,) = cross_camera_matches(seen((0, 0, 0, False), (0, 2, 2, True)), NAMES, STAMPS_NS)
    assert (match.camera_a, match.stamp_a_ns, match.pixel_a) == ("front", 100, (0.0, 0.0))
    assert (match.camera_b, match.stamp_b_ns, match.pixel_b) == ("rear", 300, (1.0, 1.0))


def test_the_owner_s_sighting_nearest_in_time_is_shown() -> None:
    rows = ((0, 0, 0, False), (0, 0, 1, False), (0, 1, 2, True))
    (match,) = cross_camera_matches(seen(*rows), NAMES, STAMPS_NS)
    assert match.stamp_a_ns == 200


def test_landmarks_of_one_camera_alone_make_no_match() -> None:
    rows = ((0, 0, 0, False), (0, 0, 1, False), (1, 1, 0, True), (1, 2, 1, True))
    assert cross_camera_matches(seen(*rows), NAMES, STAMPS_NS) == ()


def test_every_pair_gets_its_forty_however_many_another_has() -> None:
    crowd = [(i, 0, 0, False) for i in range(100)] + [(i, 1, 0, True) for i in range(100)]
    few = [(100, 0, 0, False), (100, 2, 1, True)]
    matches = cross_camera_matches(seen(*crowd, *few), NAMES, STAMPS_NS)
    pairs = [(match.camera_a, match.camera_b) for match in matches]
    assert pairs.count(("front", "left")) == 40 and pairs.count(("front", "rear")) == 1


def test_those_chosen_are_spread_over_all() -> None:
    crowd = [(i, 0, 0, False) for i in range(100)] + [(i, 1, 0, True) for i in range(100)]
    owners = [match.pixel_a[0] for match in cross_camera_matches(seen(*crowd), NAMES, STAMPS_NS)]
    assert min(owners) == 0 and max(owners) == 99 and np.diff(sorted(owners)).max() <= 3
