"""Lamps and headlights: inverse square, cosine, cone, cut-off."""

import numpy as np

from estimator.se3 import SE3
from sim.light.headlights import beam, headlight_light
from sim.light.lamps import LightSource, lamp_light

LAMP = LightSource((0.0, 0.0, 6.0), (0.0, 0.0, -1.0), 2.0)
UP, DOWN = np.array([[0.0], [0.0], [1.0]], np.float32), np.array([[0.0], [0.0], [-1.0]], np.float32)


def at(x: float, y: float, z: float) -> np.ndarray:
    return np.array([[x], [y], [z]], np.float32)


def lit(point: np.ndarray, normal: np.ndarray = UP) -> float:
    return float(lamp_light([LAMP], point, normal)[0])


def test_light_falls_off_nearly_as_the_square_of_distance() -> None:
    near, far = lit(at(0, 0, 2)), lit(at(0, 0, -2))
    assert 3.0 < near / far < 5.5


def test_what_faces_away_stays_dark() -> None:
    assert lit(at(0, 0, 0)) > 0
    assert lit(at(0, 0, 0), DOWN) == 0


def test_nothing_above_the_lamp_is_lit() -> None:
    assert lit(at(0.5, 0, 7), DOWN) == 0


def test_lamps_add_up() -> None:
    both = lamp_light([LAMP, LAMP], at(1, 2, 0), UP)[0]
    assert np.isclose(both, 2 * lit(at(1, 2, 0)))


def test_a_low_beam_is_dark_above_its_cut_off() -> None:
    below, above = beam(np.array([[20.0, 20.0], [0.0, 0.0], [-0.3, 1.5]], np.float32))
    assert below > 20 * above


def test_headlights_turn_with_the_car() -> None:
    wall_ahead, wall_left = at(20, 0, 0.3), at(0, 20, 0.3)
    towards_x, towards_y = -np.eye(3, dtype=np.float32)[:, :1], -np.eye(3, dtype=np.float32)[:, 1:2]
    straight = SE3(np.eye(3), np.zeros(3))
    left = SE3(np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]), np.zeros(3))
    assert headlight_light(straight, wall_ahead, towards_x)[0] > 0.01
    assert headlight_light(straight, wall_left, towards_y)[0] == 0
    turned = headlight_light(left, wall_left, towards_y)[0]
    assert np.isclose(turned, headlight_light(straight, wall_ahead, towards_x)[0], rtol=1e-4)
