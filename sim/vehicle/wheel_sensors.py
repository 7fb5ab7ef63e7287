"""Wheel speeds and steering angle as a car has them on its bus: quantised, a little noisy."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import mujoco
import numpy as np

from estimator.se3 import Array
from sim.seeds import rng_for
from sim.vehicle.car import STEERED, WHEELS
from sim.vehicle.inertial import InertialConfig
from sim.vehicle.motion import MotionState

RATE_HZ = 50.0
SPEED_STEP_RADPS = 0.05  # 0.06 km/h
STEER_STEP_RAD = np.deg2rad(0.1) / 16.0  # a tenth of a degree at the steering wheel
_SPEED_NOISE_RADPS = 0.03


@dataclass(frozen=True, eq=False)
class WheelSample:
    """One output.

    Attributes:
        time_s: Middle of the interval the speeds are means of, since the drive began.
        ready_s: Its end.
        speeds_radps: By wheel; forwards is positive.
        steer_rad: Mean angle of the steered wheels at the interval's end; left is positive.
    """

    time_s: float
    ready_s: float
    speeds_radps: dict[str, float]
    steer_rad: float


class WheelSensors:
    """Samples a motion ``RATE_HZ`` times a second from time zero on."""

    def __init__(
        self,
        config: InertialConfig,
        model: mujoco.MjModel,
        state_at: Callable[[float], MotionState],
        seed: int,
    ) -> None:
        """Take the physics of the car, and its state at any time."""
        self._state_at = state_at
        self._spins = [int(model.joint(f"{wheel}_spin").qposadr[0]) for wheel in WHEELS]
        self._steers = [int(model.joint(f"{wheel}_steer").qposadr[0]) for wheel in STEERED]
        self._sigma_radps = config.noise * _SPEED_NOISE_RADPS
        self._rng = rng_for(seed, "inertial.wheels")
        self._taken = 0
        self._last_rad = self._angles_rad(0.0)[0]

    def until(self, time_s: float) -> Iterator[WheelSample]:
        """Yield the samples whose interval has ended by a time, each once."""
        while (self._taken + 1) / RATE_HZ <= time_s + 1e-9:
            self._taken += 1
            angles_rad, steer_rad = self._angles_rad(self._taken / RATE_HZ)
            speeds_radps = (angles_rad - self._last_rad) * RATE_HZ
            speeds_radps = speeds_radps + self._sigma_radps * self._rng.standard_normal(len(WHEELS))
            self._last_rad = angles_rad
            rounded = np.round(speeds_radps / SPEED_STEP_RADPS) * SPEED_STEP_RADPS
            yield WheelSample(
                (self._taken - 0.5) / RATE_HZ,
                self._taken / RATE_HZ,
                dict(zip(WHEELS, rounded.tolist(), strict=True)),
                float(np.round(steer_rad / STEER_STEP_RAD) * STEER_STEP_RAD),
            )

    def _angles_rad(self, time_s: float) -> tuple[Array, float]:
        qpos = self._state_at(time_s).qpos
        return qpos[self._spins], float(qpos[self._steers].mean())
