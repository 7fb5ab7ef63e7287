"""What counts as before a camera."""

import numpy as np

from estimator.ahead import is_ahead


def test_up_to_eighty_degrees_off_the_axis_is_ahead() -> None:
    angles = np.deg2rad([0.0, 79.0, 82.0, 180.0])
    rays = np.column_stack([np.sin(angles), 0 * angles, np.cos(angles)])
    assert is_ahead(rays).tolist() == [True, True, False, False]
    assert is_ahead(7 * rays, 7 * np.ones(4)).tolist() == [True, True, False, False]


def test_what_is_no_number_is_not_ahead() -> None:
    assert not is_ahead(np.full((2, 3), np.nan)).any()
