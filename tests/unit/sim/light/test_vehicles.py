"""Cars of the traffic as the light sees them."""

import numpy as np

from estimator.se3 import SE3
from sim.light.vehicles import Vehicle, shades_of, vehicles_at
from sim.streets.kinds import Ground, draw_network
from sim.traffic.casting import build_traffic
from sim.traffic.config import TrafficConfig
from sim.traffic.traffic import Traffic


def traffic(**config: float) -> Traffic:
    plan, relief = (np.random.default_rng(k) for k in (1, 2))
    network = draw_network("straight", 60.0, Ground(), plan, relief)
    return build_traffic(TrafficConfig(**config), network, [], lambda time_s: 5.0 * time_s, 5.0, 3)


def car(x: float, y: float = 0.0) -> Vehicle:
    return Vehicle(
        SE3(np.eye(3), np.array([x, y, 0.0])), (-2.2, 2.2), 0.9, (2.1, 0.66, 0.7), (-2.2, 0.66, 0.8)
    )


def test_cars_have_lamps_where_they_are_and_cyclists_have_not() -> None:
    flowing = traffic(cars=4)
    now = vehicles_at(flowing, 2.0, np.zeros(3))
    assert len(now) > 3
    origins_m = np.vstack([troupe.stance(2.0).origins_m for troupe in flowing.troupes if troupe.models])
    assert all(np.isclose(one.world_from_car.translation, origins_m).all(axis=1).any() for one in now)
    assert vehicles_at(traffic(cyclists=4), 2.0, np.zeros(3)) == ()


def test_only_beams_near_by_are_worked_out() -> None:
    for one in vehicles_at(traffic(cars=4), 2.0, np.zeros(3)):
        away_m = np.linalg.norm(one.world_from_car.translation)
        assert one.beams == 1 if away_m < 40 else one.beams < 1


def test_a_shade_lies_beyond_what_is_ahead_and_nowhere_else() -> None:
    lamp_m = (2.1, 0.0, 0.7)
    own, ahead = car(0.0), car(20.0)
    (shade,) = shades_of(lamp_m, own, (own, ahead, car(-20.0)))
    assert np.isclose(shade.left, -shade.right)
    assert np.isclose(shade.beyond_m, 20.0 - 2.1)
