"""The car at rest: weight, ride height, geometry; and what every drive of it has in common."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from sim.vehicle.car import WHEELS, ackermann_rad, write_car
from sim.vehicle.car_physics import car_model, physics_spec
from sim.vehicle.car_state import world_from_ego
from tests.drives import CAR


@pytest.fixture(scope="module")
def settled() -> tuple[mujoco.MjModel, mujoco.MjData]:
    model = car_model(CAR, grip=1.0)
    data = mujoco.MjData(model)
    data.qpos[2] = 0.03  # dropped a little, to settle by itself
    for _ in range(2500):
        mujoco.mj_step(model, data)
    return model, data


def test_at_rest_the_ego_frame_lies_level_on_the_ground(
    settled: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    pose = world_from_ego(settled[1])
    assert abs(pose.translation[2]) < 1e-4
    assert np.degrees(pose.angle_rad) < 0.005


def test_every_tyre_carries_its_share_of_the_weight_and_gives_way_as_stated(
    settled: tuple[mujoco.MjModel, mujoco.MjData],
) -> None:
    model, data = settled
    assert data.ncon == 4
    force = np.zeros(6)
    for index, wheel in enumerate(WHEELS):
        mujoco.mj_contactForce(model, data, index, force)
        assert force[0] == pytest.approx(CAR.tyre_load_n(wheel), rel=0.002)
        assert -data.contact[index].dist == pytest.approx(
            CAR.free_radius_m(wheel) - CAR.wheel_radius_m, abs=5e-5
        )
    assert sum(map(CAR.tyre_load_n, WHEELS)) == pytest.approx(CAR.mass_kg * 9.81)


def test_the_car_that_is_seen_has_the_joints_of_the_one_that_is_driven() -> None:
    spec = physics_spec()
    write_car(spec, CAR)
    seen, driven = spec.compile(), car_model(CAR, 1.0)
    names = [[model.joint(index).name for index in range(model.njnt)] for model in (seen, driven)]
    assert names[0] == names[1]
    np.testing.assert_array_equal(seen.jnt_qposadr, driven.jnt_qposadr)


def test_inner_wheel_turns_further() -> None:
    left, right = ackermann_rad(0.2, CAR)
    assert left > 0.2 > right > 0
    assert ackermann_rad(-0.2, CAR) == pytest.approx((-right, -left))
