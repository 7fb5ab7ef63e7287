"""The car's inertial measurement unit: angular rate and specific force, with noise and a wandering bias.

Each sample is the mean over its interval, as a real unit integrates between its outputs, taken from the
simulated motion itself: what turns and accelerates the samples is what moves the cameras.

Reference: Woodman 2007, "An introduction to inertial navigation", sec. 3.2 (noise, bias, random walk).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from pydantic import Field
from scipy.spatial.transform import Rotation

from estimator.config import Config
from estimator.se3 import Array
from sim.seeds import rng_for
from sim.vehicle.car import GRAVITY_MPS2, CarConfig
from sim.vehicle.motion import MotionState


class InertialConfig(Config):
    """Inertial unit and wheel sensors; severities of 1 are those of a production car.

    Attributes:
        rate_hz: Of the inertial unit; wheel speeds come at their own, constant rate.
        noise: Times the white noise of all sensors.
        bias: Times the bias of the inertial unit, its constant part and its random walk.
    """

    rate_hz: float = Field(200.0, ge=100.0, le=400.0)
    noise: float = Field(1.0, ge=0.0, le=5.0)
    bias: float = Field(1.0, ge=0.0, le=5.0)


@dataclass(frozen=True)
class Grade:
    """How good a sensor of three axes is, in its own unit u (rad/s or m/s2) a axis.

    Attributes:
        white: Spectral density of the noise, u/sqrt(Hz).
        constant: Sigma of the bias when switched on, u.
        walk: Random walk of the bias, u/sqrt(s).
    """

    white: float
    constant: float
    walk: float


GYRO = Grade(white=1.2e-4, constant=1.7e-3, walk=2e-5)
ACCELEROMETER = Grade(white=1.2e-3, constant=0.05, walk=3e-4)


@dataclass(frozen=True, eq=False)
class ImuSample:
    """One output: means over an interval, in axes parallel to the ego frame's.

    Attributes:
        time_s: Middle of the interval, since the drive began.
        ready_s: Its end.
        angular_radps: (3,).
        force_mps2: (3,) specific force: acceleration minus gravity, at the unit's place.
        bias_radps: (3,) what is wrong in ``angular_radps`` besides noise.
        bias_mps2: (3,) what is wrong in ``force_mps2`` besides noise.
    """

    time_s: float
    ready_s: float
    angular_radps: Array
    force_mps2: Array
    bias_radps: Array
    bias_mps2: Array


class Drift:
    """White noise and wandering bias of one sensor, sample by sample."""

    def __init__(self, grade: Grade, config: InertialConfig, seed: int, sensor: str) -> None:
        self._white = config.noise * grade.white * np.sqrt(config.rate_hz)
        self._walk = config.bias * grade.walk / np.sqrt(config.rate_hz)
        self._noise_rng = rng_for(seed, f"inertial.{sensor}.noise")
        self._bias_rng = rng_for(seed, f"inertial.{sensor}.bias")
        self.bias: Array = config.bias * grade.constant * self._bias_rng.standard_normal(3)

    def spoil(self, true: Array) -> Array:
        """Return what the sensor says of a (3,) value; the bias wanders on."""
        self.bias = self.bias + self._walk * self._bias_rng.standard_normal(3)
        return np.asarray(true + self.bias + self._white * self._noise_rng.standard_normal(3))


class InertialUnit:
    """Samples a motion at an even rate from time zero on."""

    def __init__(
        self, config: InertialConfig, state_at: Callable[[float], MotionState], car: CarConfig, seed: int
    ) -> None:
        self._rate_hz, self._state_at = config.rate_hz, state_at
        self._arm_m = np.array(car.imu_position_m)
        self._gyro = Drift(GYRO, config, seed, "gyro")
        self._accelerometer = Drift(ACCELEROMETER, config, seed, "accelerometer")
        self._taken = 0
        self._last = self._read(0.0)

    def until(self, time_s: float) -> Iterator[ImuSample]:
        """Yield the samples whose interval has ended by a time, each once."""
        while (self._taken + 1) / self._rate_hz <= time_s + 1e-9:
            start_s, self._taken = self._taken / self._rate_hz, self._taken + 1
            (before, before_mps), now = self._last, self._read(self._taken / self._rate_hz)
            after, after_mps = self._last = now
            turn_rad = (before.inv() * after).as_rotvec()
            middle = before * Rotation.from_rotvec(turn_rad / 2)
            acceleration_mps2 = (after_mps - before_mps) * self._rate_hz + [0.0, 0.0, GRAVITY_MPS2]
            angular = self._gyro.spoil(turn_rad * self._rate_hz)
            force = self._accelerometer.spoil(middle.inv().apply(acceleration_mps2))
            end_s = self._taken / self._rate_hz
            biases = self._gyro.bias, self._accelerometer.bias
            yield ImuSample((start_s + end_s) / 2, end_s, angular, force, *biases)

    def _read(self, time_s: float) -> tuple[Rotation, Array]:
        """Return the car's attitude and the (3,) velocity of the unit's place, in the world."""
        state = self._state_at(time_s)
        world_from_ego = Rotation.from_quat(state.qpos[[4, 5, 6, 3]])
        return world_from_ego, state.qvel[:3] + world_from_ego.apply(np.cross(state.qvel[3:6], self._arm_m))
