"""Lamps and headlights: inverse square, cosine, cone, cut-off."""

import numpy as np

from estimator.camera import Camera
from estimator.se3 import SE3
from sim.light.headlights import beam, headlamps, headlight_light, tail_lamps
from sim.light.lamps import LightSource, lamp_light
from sim.light.sprites import add_lamps
from sim.light.vehicles import Vehicle, driven_vehicle
from sim.rendering.view import View

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
    straight = driven_vehicle(SE3())
    left = driven_vehicle(SE3(np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]), np.zeros(3)))
    assert headlight_light(straight, (), wall_ahead, towards_x)[0] > 0.01
    assert headlight_light(straight, (), wall_left, towards_y)[0] == 0
    turned = headlight_light(left, (), wall_left, towards_y)[0]
    assert np.isclose(turned, headlight_light(straight, (), wall_ahead, towards_x)[0], rtol=1e-4)


def car_at(x: float, y: float = 0.0, *, oncoming: bool = False) -> Vehicle:
    turn = np.diag([-1.0, -1.0, 1.0]) if oncoming else np.eye(3)
    return Vehicle(SE3(turn, np.array([x, y, 0.0])), (-2.2, 2.2), 0.9, (2.1, 0.66, 0.7), (-2.2, 0.66, 0.8))


def test_a_car_ahead_takes_the_beam_and_leaves_the_dark_beyond() -> None:
    own, towards = driven_vehicle(SE3()), -np.eye(3, dtype=np.float32)[:, :1]
    ahead, aside = car_at(15.0), car_at(15.0, 8.0)
    tail, beyond = at(12.8, 0.3, 0.6), at(30.0, 0.3, 0.2)
    free = headlight_light(own, (), beyond, towards)[0]
    assert headlight_light(own, (ahead,), tail, towards)[0] > 0.1
    assert headlight_light(own, (ahead,), beyond, towards)[0] == 0
    assert headlight_light(own, (aside,), beyond, towards)[0] == free > 0


def test_one_lamp_for_both_lights_the_far_road_alike() -> None:
    car, far = car_at(0.0), at(25.0, 1.0, 0.0)
    both = headlight_light(car, (), far, UP)[0]
    assert np.isclose(headlight_light(car, (car,), far, UP, as_one=True)[0], both, rtol=0.02)


def test_headlamps_are_seen_from_before_and_tail_lamps_from_behind() -> None:
    view = View(
        Camera("pinhole", (160, 100), (115.0, 115.0), (79.5, 49.5)),
        SE3(np.array([[0.0, 0, 1], [-1, 0, 0], [0, -1, 0]]), np.array([0.0, 0.0, 1.0])),
    )

    def level(car: Vehicle) -> float:
        light = np.zeros((100, 160), np.float32)
        add_lamps(light, [*headlamps(car), *tail_lamps(car)], view, np.full((100, 160), 100.0, np.float32))
        return float(light.max())

    assert level(car_at(12.0, oncoming=True)) > 5 * level(car_at(12.0)) > 20
