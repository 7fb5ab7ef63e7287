from __future__ import annotations

from collections.abc import Iterator

import mujoco
import numpy as np
import pytest

from estimator.se3 import SE3, Array
from sim.scene import Scene, physics_spec
from sim.stage import Stage
from sim.vehicle.car import CarConfig, ackermann_rad, write_car, write_ground
from sim.vehicle.drive import DriveConfig, velocity_in_ego, world_from_ego
from sim.vehicle.follower import Follower

CAR = CarConfig()


@pytest.fixture(scope="module")
def model() -> mujoco.MjModel:
    spec = physics_spec()
    write_car(spec, CAR)
    write_ground(spec)
    return spec.compile()


def bend(radius_m: float) -> Array:
    """20 m straight, a quarter circle to the left, 30 m straight."""
    turn = np.arange(0.25 / radius_m, np.pi / 2, 0.25 / radius_m)[:, None]
    first = np.column_stack([np.arange(0, 20.1, 0.25), np.zeros(81)])
    arc = [20, radius_m] + radius_m * np.hstack([np.sin(turn), -np.cos(turn)])
    last = np.column_stack([np.full(120, 20 + radius_m), radius_m + 0.25 * np.arange(1, 121)])
    return np.concatenate([first, arc, last])


def test_at_rest_the_ego_frame_lies_level_on_the_ground(model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    data.qpos[2] = 0.03  # dropped a little, to settle by itself
    for _ in range(2500):
        mujoco.mj_step(model, data)
    pose = world_from_ego(data)
    assert abs(pose.translation[2]) < 0.001
    assert np.degrees(pose.angle_rad) < 0.02


def test_tyres_and_springs_carry_the_cars_weight(model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    for _ in range(1500):
        mujoco.mj_step(model, data)
    load_n = sum(_normal_force_n(model, data, contact) for contact in range(data.ncon))
    assert data.ncon == 4
    assert load_n == pytest.approx(CAR.mass_kg * 9.81, rel=0.01)


def _normal_force_n(model: mujoco.MjModel, data: mujoco.MjData, contact: int) -> float:
    force = np.zeros(6)
    mujoco.mj_contactForce(model, data, contact, force)
    return float(force[0])


def states(model: mujoco.MjModel, config: DriveConfig, path_m: Array) -> Iterator[mujoco.MjData]:
    """Yield the world at every bundle of a drive."""
    stage = Stage(Scene(model, {}, path_m, CAR), config)
    for index in range(config.bundle_count):
        yield stage.at(config.time_s(index))


@pytest.mark.parametrize("speed_mps", [2.0, 5.0, 8.0])
def test_follows_a_bend_within_0_3_m_at_the_asked_speed(model: mujoco.MjModel, speed_mps: float) -> None:
    path_m = bend(12.0)
    for data in states(model, DriveConfig(speed_mps=speed_mps, distance_m=55.0), path_m):
        position_m = world_from_ego(data).translation[:2]
        assert np.linalg.norm(path_m - position_m, axis=1).min() < 0.3
        assert velocity_in_ego(model, data)[3] == pytest.approx(speed_mps, abs=0.1)
    assert position_m[1] > 20  # it did come out of the bend


def test_leans_outward_in_a_left_bend(model: mujoco.MjModel) -> None:
    leans = [
        world_from_ego(data).rotation[2, 1]
        for data in states(model, DriveConfig(distance_m=35.0), bend(12.0))
    ]
    assert 0.5 < np.degrees(max(leans)) < 4.0


def test_first_bundle_is_at_the_start_of_the_path_already_at_speed(model: mujoco.MjModel) -> None:
    data = next(states(model, DriveConfig(), bend(12.0)))
    assert np.linalg.norm(world_from_ego(data).translation) < 0.02
    assert velocity_in_ego(model, data)[3] == pytest.approx(5.0, abs=0.05)
    assert np.degrees(world_from_ego(data).angle_rad) < 0.05


def test_a_drive_has_a_bundle_at_both_ends() -> None:
    config = DriveConfig(speed_mps=5.0, distance_m=50.0, rate_hz=10.0)
    assert config.bundle_count == 101
    assert config.time_s(100) == pytest.approx(10.0)


def test_inner_wheel_turns_further() -> None:
    left, right = ackermann_rad(0.2, CAR)
    assert left > 0.2 > right > 0
    assert ackermann_rad(-0.2, CAR) == pytest.approx((-right, -left))


def test_follower_steers_back_to_the_path() -> None:
    follower = Follower(np.array([[0.0, 0.0], [50.0, 0.0]]), CAR.wheelbase_m, run_up_m=5.0)
    beside = SE3(np.eye(3), np.array([2.0, 1.0, 0.0]))
    assert follower.steer_rad(beside, 5.0) < -0.1
