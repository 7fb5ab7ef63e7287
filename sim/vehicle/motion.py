"""The driven car's state at any instant: physics runs ahead, and its last second is kept.

Physics takes the same steps whatever the bundle rate or the shutter, so neither changes the drive.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

import mujoco
import numpy as np

from estimator.se3 import Array
from sim.vehicle.car import CarConfig
from sim.vehicle.drive import RUN_UP_S, DriveConfig, place_rolling, step
from sim.vehicle.follower import Follower

STEP_S = 0.002
KEPT_S = 1.0


@dataclass(frozen=True, eq=False)
class MotionState:
    """Generalised positions and velocities of the model at one instant."""

    qpos: Array
    qvel: Array


class Motion:
    """One drive along a path; time zero is when the ego origin passes the path's first point."""

    def __init__(self, model: mujoco.MjModel, config: DriveConfig, path_m: Array, car: CarConfig) -> None:
        """Take an (N, 2) world path; rolls up to its first point."""
        self._model, self._data, self._config, self._car = model, mujoco.MjData(model), config, car
        model.opt.timestep = STEP_S
        self._follower = Follower(path_m, car.wheelbase_m, config.speed_mps * RUN_UP_S + 1.0)
        self._states: deque[MotionState] = deque(maxlen=round(KEPT_S / STEP_S) + 2)
        self._newest = 0  # index of the newest state in steps since time zero
        place_rolling(model, self._data, path_m, config.speed_mps, car)
        self._keep()
        heading = path_m[1] - path_m[0]
        while (self._data.qpos[:2] - path_m[0]) @ heading < 0:
            self._step()
        self._newest = 0

    def state_at(self, time_s: float) -> MotionState:
        """Return the state at a time, interpolated between physics steps.

        Times may be asked for in any order, but none ``KEPT_S`` older than the newest.
        """
        at = time_s / STEP_S
        while self._newest < at:
            self._step()
        back = self._newest - at
        if back > len(self._states) - 1:
            raise ValueError(f"{time_s:.3f} s is forgotten; newest is {self._newest * STEP_S:.3f} s")
        newer = int(back)
        after = self._states[-1 - newer]
        if back == newer:
            return after
        before, share = self._states[-2 - newer], back - newer  # of a step, back from the later state
        change = np.zeros(self._model.nv)
        mujoco.mj_differentiatePos(self._model, change, 1.0, after.qpos, before.qpos)
        qpos = after.qpos.copy()
        mujoco.mj_integratePos(self._model, qpos, change, share)
        return MotionState(qpos, after.qvel + share * (before.qvel - after.qvel))

    def _step(self) -> None:
        step(self._model, self._data, self._follower, self._config.speed_mps, self._car)
        self._newest += 1
        self._keep()

    def _keep(self) -> None:
        self._states.append(MotionState(self._data.qpos.copy(), self._data.qvel.copy()))
