"""Inertial and wheel samples as ROS 2 messages, each on its topic, with the unit's place and true bias.

A message arrives when its interval ends; its stamp is the interval's middle.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from estimator.se3 import Array
from sim.messages import TYPES, header, vector
from sim.vehicle.car import CarConfig
from sim.vehicle.car_sensors import CarSamples
from sim.vehicle.inertial import ACCELEROMETER, GYRO, ImuSample, InertialConfig
from sim.vehicle.wheel_sensors import WheelSample
from sim.world import CLOCK_START_NS

FRAME = "imu"
STEERING = "steering"
_T = TYPES.types
INERTIAL_TOPICS = {
    "/tf_static": "tf2_msgs/msg/TFMessage",
    "/imu": "sensor_msgs/msg/Imu",
    "/wheel_speeds": "sensor_msgs/msg/JointState",
    "/truth/imu_bias": "sensor_msgs/msg/Imu",
}
_UNKNOWN = np.array([-1.0, *[0.0] * 8])  # sensor_msgs/Imu: no orientation is measured


class InertialTopics:
    """What a bag gets on ``INERTIAL_TOPICS``; remembers that the unit's place was told."""

    def __init__(self, config: InertialConfig) -> None:
        self._config, self._told_place = config, False

    def messages(self, samples: CarSamples, truth_ns: int) -> Iterator[tuple[str, int, Any]]:
        """Yield topic, time of arrival and message of all samples up to a bundle's stamp."""
        if not self._told_place:
            yield "/tf_static", truth_ns, imu_place(CarConfig().imu_position_m, truth_ns)
            self._told_place = True
        for each in samples.imu:
            yield "/imu", _stamp_ns(each.ready_s), imu(each, _stamp_ns(each.time_s), self._config)
        for wheels in samples.wheels:
            message = wheel_speeds(wheels, _stamp_ns(wheels.time_s))
            yield "/wheel_speeds", _stamp_ns(wheels.ready_s), message
        if samples.imu:
            yield "/truth/imu_bias", truth_ns, imu_bias(samples.imu[-1], truth_ns)


def imu(sample: ImuSample, stamp_ns: int, config: InertialConfig) -> Any:
    """Return a sensor_msgs/Imu; its covariances are those of the white noise."""
    angular, force = (
        (config.noise * grade.white) ** 2 * config.rate_hz * np.eye(3) for grade in (GYRO, ACCELEROMETER)
    )
    return _imu(sample.angular_radps, sample.force_mps2, stamp_ns, (angular.ravel(), force.ravel()))


def imu_bias(sample: ImuSample, stamp_ns: int) -> Any:
    """Return a sensor_msgs/Imu that holds the true biases in place of the measurements."""
    return _imu(sample.bias_radps, sample.bias_mps2, stamp_ns, (np.zeros(9), np.zeros(9)))


def wheel_speeds(sample: WheelSample, stamp_ns: int) -> Any:
    """Return a sensor_msgs/JointState: the wheels' speeds in ``velocity``, the steering in ``position``."""
    count = len(sample.speeds_radps)
    return _T["sensor_msgs/msg/JointState"](
        header=header(stamp_ns, "ego"),
        name=[*sample.speeds_radps, STEERING],
        position=np.array([*[np.nan] * count, sample.steer_rad]),
        velocity=np.array([*sample.speeds_radps.values(), np.nan]),
        effort=np.zeros(0),
    )


def imu_place(position_m: tuple[float, float, float], stamp_ns: int) -> Any:
    """Return the tf2_msgs/TFMessage from ``ego`` to the unit, whose axes are parallel to ego's."""
    transform = _T["geometry_msgs/msg/Transform"](
        vector(np.array(position_m)), _T["geometry_msgs/msg/Quaternion"](0.0, 0.0, 0.0, 1.0)
    )
    stamped = _T["geometry_msgs/msg/TransformStamped"](header(stamp_ns, "ego"), FRAME, transform)
    return _T["tf2_msgs/msg/TFMessage"]([stamped])


def _imu(angular: Array, force: Array, stamp_ns: int, covariances: tuple[Array, Array]) -> Any:
    return _T["sensor_msgs/msg/Imu"](
        header=header(stamp_ns, FRAME),
        orientation=_T["geometry_msgs/msg/Quaternion"](0.0, 0.0, 0.0, 1.0),
        orientation_covariance=_UNKNOWN,
        angular_velocity=vector(angular),
        angular_velocity_covariance=covariances[0],
        linear_acceleration=vector(force),
        linear_acceleration_covariance=covariances[1],
    )


def _stamp_ns(time_s: float) -> int:
    return CLOCK_START_NS + round(time_s * 1e9)
