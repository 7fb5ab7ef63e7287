"""The driver: looks at route and plan a hundred times a second, and moves steering wheel and pedals.

Brakes are friction on the wheels' joints, so they hold a standing car and never push it back.
"""

from __future__ import annotations

import mujoco
import numpy as np

from sim.vehicle.car import DRIVEN, GRAVITY_MPS2, STEERED, WHEELS, CarConfig, ackermann_rad
from sim.vehicle.car_state import velocity_in_ego, world_from_ego
from sim.vehicle.follower import Follower
from sim.vehicle.plan import SpeedPlan

_SPEED_GAIN_PS, _PLACE_GAIN_PS2 = 2.0, 0.6
_HURRY_MPS2 = 0.5  # most that is done to make up for being behind the plan
_HARDEST_PUSH_MPS2, _HARDEST_BRAKE_MPS2 = 4.0, 9.5
_ENGINE_BRAKE_MPS2 = 0.6
_STANDING_MPS = 0.03
_FRONT_BRAKES = 0.6
_SLIP_ALLOWED = 0.15  # beyond it the brake of a wheel is eased, as anti-lock brakes do
_ANTI_LOCK_ABOVE_MPS = 1.5


class Driver:
    """Drives one car along one route."""

    def __init__(
        self, model: mujoco.MjModel, follower: Follower, plan: SpeedPlan, car: CarConfig, backwards: bool
    ) -> None:
        self._model, self._follower, self._plan, self._car = model, follower, plan, car
        self._direction = -1.0 if backwards else 1.0
        self._spins = [int(model.joint(f"{wheel}_spin").dofadr[0]) for wheel in WHEELS]
        self._motors = [int(model.actuator(f"{wheel}_motor").id) for wheel in DRIVEN]
        self._servos = [int(model.actuator(f"{wheel}_servo").id) for wheel in STEERED]

    def act(self, data: mujoco.MjData, time_s: float, rolling_up: bool) -> None:
        """Set steering angle, motor and brakes for what the plan wants at a time.

        Args:
            data: State of the car.
            time_s: Since the drive began.
            rolling_up: Before the start only the speed counts, not the place.
        """
        pose = world_from_ego(data)
        speed_mps = self._direction * float(velocity_in_ego(self._model, data)[3])
        wanted_mps = self._plan.speed_mps(time_s)
        position_m, heading = pose.translation[:2], pose.rotation[:2, 0]
        self._steer(data, self._follower.steer_rad(position_m, data.qvel[:2], heading))
        uphill_mps2 = self._direction * GRAVITY_MPS2 * pose.rotation[2, 0]
        push_mps2 = _SPEED_GAIN_PS * (wanted_mps - speed_mps) + uphill_mps2
        if not rolling_up:
            behind_m = self._plan.distance_m(time_s) - self._follower.progress_m
            push_mps2 += self._plan.acceleration_mps2(time_s)
            push_mps2 += float(np.clip(_PLACE_GAIN_PS2 * behind_m, -_HURRY_MPS2, _HURRY_MPS2))
        standing = wanted_mps < _STANDING_MPS and abs(speed_mps) < 10 * _STANDING_MPS
        self._press(data, -_HARDEST_BRAKE_MPS2 / 2 if standing else push_mps2, speed_mps)

    def _steer(self, data: mujoco.MjData, steer_rad: float) -> None:
        limit_rad = self._car.steer_limit_rad
        for servo, angle_rad in zip(self._servos, ackermann_rad(steer_rad, self._car), strict=True):
            data.ctrl[servo] = min(max(angle_rad, -limit_rad), limit_rad)

    def _press(self, data: mujoco.MjData, push_mps2: float, speed_mps: float) -> None:
        """Push or slow by an acceleration along the direction of travel."""
        engine_brake_mps2 = (
            _ENGINE_BRAKE_MPS2 if speed_mps > 1.0 and push_mps2 > -4 * _ENGINE_BRAKE_MPS2 else 0.0
        )
        motor_mps2 = min(max(push_mps2, -engine_brake_mps2), _HARDEST_PUSH_MPS2)
        brake_mps2 = min(motor_mps2 - push_mps2, _HARDEST_BRAKE_MPS2) if push_mps2 < motor_mps2 else 0.0
        torque_nm = self._car.mass_kg * self._car.wheel_radius_m / 2  # a wheel of an axle, by acceleration
        for motor in self._motors:
            data.ctrl[motor] = self._direction * motor_mps2 * torque_nm
        for wheel, spin in zip(WHEELS, self._spins, strict=True):
            share = _FRONT_BRAKES if wheel in STEERED else 1 - _FRONT_BRAKES
            locking = speed_mps > _ANTI_LOCK_ABOVE_MPS and (
                self._direction * data.qvel[spin] * self._car.rolling_radius_m(wheel)
                < (1 - _SLIP_ALLOWED) * speed_mps
            )
            self._model.dof_frictionloss[spin] = (0.3 if locking else 1.0) * share * brake_mps2 * torque_nm
