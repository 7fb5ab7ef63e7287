"""The driven car's state at any instant: physics runs ahead, and its last second is kept.

Physics takes the same steps whatever the bundle rate or the shutter, so neither changes the drive.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

import mujoco
import numpy as np

from estimator.errors import InputError
from estimator.se3 import Array
from sim.vehicle.car import CarConfig
from sim.vehicle.car_physics import STEP_S, car_model
from sim.vehicle.drive import DriveConfig
from sim.vehicle.driver import Driver
from sim.vehicle.follower import Follower
from sim.vehicle.ground_contact import GroundContact, Road
from sim.vehicle.plan import plan_speed
from sim.vehicle.route import Route, backwards_from
from sim.vehicle.start import place_on_route
from sim.vehicle.tyre import set_slip_speed

KEPT_S = 1.0
_RESERVE_S = 0.2  # kept beyond, for shutters that have closed after the newest bundle
_RUN_UP_S = 2.0
_LONGEST_RUN_UP_S = 20.0
_DRIVER_EVERY = 5  # steps
_FARTHEST_ASIDE_M = 6.0  # beyond it the car drives among houses, and pictures make no sense
_WANTED = "wanted less of drive.speed_mps, drive.lateral_mps2 or the street's slope, or more drive.grip"


@dataclass(frozen=True, eq=False)
class MotionState:
    """Generalised positions and velocities of the car at one instant."""

    qpos: Array
    qvel: Array


def in_order_of_travel(config: DriveConfig, route: Route) -> Route:
    """Return the route, given in the direction of its lane, as it is driven."""
    return backwards_from(route, config.distance_m) if config.reverse else route


class Motion:
    """One drive along a route; time zero is when the ego origin passes its first point, or starts from there.

    Attributes:
        model: The physics of the car alone.
        plan: Where the car means to be at any time.
    """

    def __init__(self, config: DriveConfig, route: Route, road: Road | None, car: CarConfig) -> None:
        """Roll up to the start of the drive.

        Args:
            config: What is asked of the drive.
            route: In the direction of its lane; a drive in reverse starts at its far end.
            road: What the wheels feel; None for the plane z = 0.
            car: The car's sizes.

        Raises:
            InputError: The car cannot get to its start; so does ``state_at`` where it loses its road.
        """
        self._route = in_order_of_travel(config, route)
        self.model = car_model(car, config.grip)
        self.plan = plan_speed(config, self._route)
        self._data, self._car = mujoco.MjData(self.model), car
        self._ground = None if road is None else GroundContact(self.model, road, car)
        self._states: deque[MotionState] = deque(maxlen=round((KEPT_S + _RESERVE_S) / STEP_S) + 2)
        start_mps = self.plan.speed_mps(0.0)
        run_up_m = start_mps * _RUN_UP_S
        place_on_route(self.model, self._data, self._route, -run_up_m, config.reverse, start_mps, road, car)
        self._follower = Follower(self._route, car.wheelbase_m, -run_up_m)
        self._driver = Driver(self.model, self._follower, self.plan, car, config.reverse)
        self._steps, self._zero = 0, round(_RUN_UP_S / STEP_S)
        self._run_up(still=start_mps == 0.0)

    def state_at(self, time_s: float) -> MotionState:
        """Return the state at a time, interpolated between physics steps.

        Times may be asked for in any order, but none ``KEPT_S`` older than the newest.
        """
        at = time_s / STEP_S
        while self._newest < at + 0.5:
            self._step()
        before, share = self._pair(at, time_s)
        qpos = before[0].qpos.copy()
        if share:
            change = np.zeros(self.model.nv)
            mujoco.mj_differentiatePos(self.model, change, 1.0, before[0].qpos, before[1].qpos)
            mujoco.mj_integratePos(self.model, qpos, change, share)
        # A step's velocity is that of the way to it: of the time half a step before.
        before, share = self._pair(at + 0.5, time_s)
        return MotionState(qpos, before[0].qvel + share * (before[1].qvel - before[0].qvel))

    @property
    def _newest(self) -> int:
        """Index of the newest state in steps since time zero."""
        return self._steps - self._zero

    def _pair(self, at: float, time_s: float) -> tuple[tuple[MotionState, MotionState], float]:
        """Return the states around a time in steps, and how far between them it lies."""
        before = int(np.floor(at))
        oldest = self._newest - len(self._states) + 1
        if before < oldest:
            raise ValueError(f"{time_s:.3f} s is forgotten; newest is {self._newest * STEP_S:.3f} s")
        index = before - oldest
        return (self._states[index], self._states[min(index + 1, len(self._states) - 1)]), at - before

    def _run_up(self, still: bool) -> None:
        """Let springs and speed settle; then time zero is when the start is passed."""
        self._keep()
        start_m, direction = self._route.point_m(0.0), self._route.direction(0.0)
        while self._newest < 0 if still else (self._data.qpos[:2] - start_m) @ direction < 0:
            if self._steps * STEP_S > _LONGEST_RUN_UP_S:
                raise InputError(f"drive: the car never gets to its start; {_WANTED}")
            self._step(rolling_up=True)
        self._zero = self._steps

    def _step(self, rolling_up: bool = False) -> None:
        if self._steps % _DRIVER_EVERY == 0:
            self._driver.act(self._data, 0.0 if rolling_up else self._newest * STEP_S, rolling_up)
            if abs(self._follower.aside_m) > _FARTHEST_ASIDE_M:
                raise InputError(
                    f"drive: the car leaves the road after {max(self._newest * STEP_S, 0.0):.1f} s; {_WANTED}"
                )
            set_slip_speed(
                self.model, "front_left_contact", self._car.tyre, float(np.hypot(*self._data.qvel[:2]))
            )
        if self._ground is not None:
            self._ground.follow(self._data, self._steps)
        mujoco.mj_step(self.model, self._data)
        if self._data.warning[mujoco.mjtWarning.mjWARN_BADQACC].number:  # MuJoCo goes on from a fresh start
            raise InputError(f"drive: the car tumbles after {self._newest * STEP_S:.1f} s; {_WANTED}")
        self._steps += 1
        self._keep()

    def _keep(self) -> None:
        self._states.append(MotionState(self._data.qpos.copy(), self._data.qvel.copy()))
