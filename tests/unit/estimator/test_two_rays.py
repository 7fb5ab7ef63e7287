"""Where two rays of one point meet."""

from __future__ import annotations

import numpy as np

from estimator.two_rays import depths_m, midpoints

CENTERS = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])
POINT = np.array([0.3, -0.4, 5.0])
FIRST, LAST = ((POINT - center)[None] / np.linalg.norm(POINT - center) for center in CENTERS)


def test_rays_of_one_point_meet_in_it() -> None:
    depths = depths_m(FIRST, LAST, CENTERS[1:] - CENTERS[:1])
    np.testing.assert_allclose(np.ravel(depths), np.linalg.norm(POINT - CENTERS, axis=1))
    np.testing.assert_allclose(midpoints(FIRST, CENTERS[:1], LAST, CENTERS[1], 0.01), POINT[None])


def test_what_lies_behind_a_camera_or_between_rays_too_alike_is_unknown() -> None:
    assert np.isnan(midpoints(-FIRST, CENTERS[:1], -LAST, CENTERS[1], 0.01)).all()
    assert np.isnan(midpoints(FIRST, CENTERS[:1], LAST, CENTERS[1], 0.5)).all()
