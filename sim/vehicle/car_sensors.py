"""All sensors of the car besides its cameras; a car without them is one whose sensors say nothing."""

from __future__ import annotations

from dataclasses import dataclass

from sim.vehicle.car import CarConfig
from sim.vehicle.inertial import ImuSample, InertialConfig, InertialUnit
from sim.vehicle.motion import Motion
from sim.vehicle.wheel_sensors import WheelSample, WheelSensors


@dataclass(frozen=True)
class CarSamples:
    """What the sensors have put out since they were asked last, oldest first."""

    imu: tuple[ImuSample, ...] = ()
    wheels: tuple[WheelSample, ...] = ()


class CarSensors:
    """The inertial unit and the wheel sensors of one drive."""

    def __init__(self, config: InertialConfig | None, motion: Motion, car: CarConfig, seed: int) -> None:
        """Take the sensors' settings; None for a car without them."""
        self._imu = self._wheels = None
        if config is not None:
            self._imu = InertialUnit(config, motion.state_at, car, seed)
            self._wheels = WheelSensors(config, motion.model, motion.state_at, seed)

    def until(self, time_s: float) -> CarSamples:
        """Return the outputs that ended by a time, at most a second after those returned last."""
        if self._imu is None or self._wheels is None:
            return CarSamples()
        return CarSamples(tuple(self._imu.until(time_s)), tuple(self._wheels.until(time_s)))
