"""The inertial unit: without noise it tells the motion itself; with noise, exactly the stated noise."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from sim.vehicle.car import GRAVITY_MPS2
from sim.vehicle.car_sensors import CarSensors
from sim.vehicle.drive import DriveConfig
from sim.vehicle.inertial import ACCELEROMETER, GYRO, Drift, ImuSample, InertialConfig
from sim.vehicle.motion import Motion
from tests.drives import CAR, STRAIGHT, Ramp, Seen, bend

SILENT = InertialConfig(noise=0.0, bias=0.0)
ARM_M = np.array(CAR.imu_position_m)


def sample(motion: Motion, config: InertialConfig, until_s: float, seed: int = 0) -> list[ImuSample]:
    """Ask as a simulation does: bundle by bundle."""
    sensors = CarSensors(config, motion, CAR, seed)
    return [each for time_s in np.arange(0.0, until_s + 0.05, 0.1) for each in sensors.until(time_s).imu]


def seen_at(motion: Motion, time_s: float) -> Seen:
    return Seen(time_s, motion.state_at(time_s))


@pytest.mark.parametrize("rate_hz", [100.0, 200.0, 400.0])
def test_integrating_a_noiseless_unit_gives_the_pose_after_ten_seconds_of_bend_and_humps(
    rate_hz: float,
) -> None:
    config = DriveConfig(speed_mps=6.0, distance_m=65.0)
    motion = Motion(config, bend(15.0), Ramp(slope=0.05, hump_m=0.05, hump_at_m=15.0), CAR)
    start = seen_at(motion, 0.0)
    attitude = Rotation.from_matrix(start.world_from_ego.rotation)
    place_m = start.world_from_ego.apply(ARM_M[None])[0]
    speed_mps = start.state.qvel[:3] + attitude.apply(np.cross(start.state.qvel[3:6], ARM_M))
    for each in sample(motion, SILENT.model_copy(update={"rate_hz": rate_hz}), 10.0):
        turn = Rotation.from_rotvec(each.angular_radps / rate_hz)
        middle = attitude * Rotation.from_rotvec(each.angular_radps / rate_hz / 2)
        change_mps = (middle.apply(each.force_mps2) - [0.0, 0.0, GRAVITY_MPS2]) / rate_hz
        place_m = place_m + (speed_mps + change_mps / 2) / rate_hz
        speed_mps, attitude = speed_mps + change_mps, attitude * turn
    end = seen_at(motion, 10.0).world_from_ego
    assert np.linalg.norm(place_m - end.apply(ARM_M[None])[0]) < 0.02
    assert np.degrees((attitude.inv() * Rotation.from_matrix(end.rotation)).magnitude()) < 1e-6


def test_a_car_at_rest_feels_its_own_weight_and_its_bias() -> None:
    motion = Motion(DriveConfig(profile="pull_away"), STRAIGHT, None, CAR)
    (still, *_, last) = sample(motion, InertialConfig(noise=0.0), 0.9)
    for each in (still, last):
        np.testing.assert_allclose(each.angular_radps, each.bias_radps, atol=1e-6)
        np.testing.assert_allclose(each.force_mps2 - each.bias_mps2, [0.0, 0.0, GRAVITY_MPS2], atol=1e-4)
    assert np.abs(last.bias_mps2).max() > 1e-3
    assert not np.array_equal(still.bias_mps2, last.bias_mps2)


def test_noise_has_the_stated_density_and_bias_walks_as_stated() -> None:
    """Allan deviation at one sample is the white noise; over long means the walk shows."""
    config = InertialConfig(rate_hz=100.0)
    for grade in (GYRO, ACCELEROMETER):
        sensor = Drift(grade, config, 3, "test")
        said = np.array([sensor.spoil(np.zeros(3)) for _ in range(40_000)])
        short = np.sqrt(np.mean(np.diff(said, axis=0) ** 2) / 2)
        assert short == pytest.approx(grade.white * np.sqrt(100.0), rel=0.02)
        means = said.reshape(-1, 100, 3).mean(1)  # over a second
        allan = np.sqrt(np.mean(np.diff(means, axis=0) ** 2) / 2)
        assert allan == pytest.approx(np.hypot(grade.white, grade.walk / np.sqrt(3)), rel=0.1)


def test_bias_walks_with_the_root_of_time_and_starts_with_the_stated_sigma() -> None:
    config = InertialConfig(rate_hz=100.0, noise=0.0)
    starts, walks = [], []
    for seed in range(150):
        sensor = Drift(ACCELEROMETER, config, seed, "test")
        starts.append(sensor.bias)
        for _ in range(400):
            sensor.spoil(np.zeros(3))
        walks.append(sensor.bias - starts[-1])
    assert np.std(starts) == pytest.approx(ACCELEROMETER.constant, rel=0.1)
    assert np.std(walks) == pytest.approx(2.0 * ACCELEROMETER.walk, rel=0.1)


def test_noise_and_bias_do_not_touch_each_other() -> None:
    def said(config: InertialConfig) -> list[ImuSample]:
        return sample(Motion(DriveConfig(), STRAIGHT, None, CAR), config, 0.5)

    both, quiet, unbiased = (
        said(InertialConfig(**settings)) for settings in ({}, {"noise": 0.0}, {"bias": 0.0})
    )
    silent = said(SILENT)
    for a, b, c, d in zip(both, quiet, unbiased, silent, strict=True):
        np.testing.assert_array_equal(a.bias_radps, b.bias_radps)
        np.testing.assert_allclose(
            a.angular_radps - d.angular_radps,
            (b.angular_radps - d.angular_radps) + (c.angular_radps - d.angular_radps),
            atol=1e-15,
        )


def test_samples_come_at_an_even_rate_each_once_and_none_before_it_is_ready() -> None:
    motion = Motion(DriveConfig(), STRAIGHT, None, CAR)
    sensors = CarSensors(InertialConfig(rate_hz=130.0), motion, CAR, 0)
    times_s = []
    for index in range(8):
        for each in sensors.until(index * 0.13).imu:
            assert each.time_s < each.ready_s <= index * 0.13 + 1e-9
            times_s.append(each.time_s)
    np.testing.assert_allclose(times_s, (np.arange(len(times_s)) + 0.5) / 130.0)
    assert len(times_s) == int(7 * 0.13 * 130.0 + 1e-6)


def test_a_car_without_sensors_says_nothing() -> None:
    motion = Motion(DriveConfig(), STRAIGHT, None, CAR)
    samples = CarSensors(None, motion, CAR, 0).until(0.5)
    assert samples.imu == () and samples.wheels == ()
