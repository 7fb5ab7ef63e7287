"""The world at any instant: car, cameras and whatever else moves, put where they are at that time."""

from __future__ import annotations

import mujoco

from sim.scene import Scene
from sim.vehicle.car import CHASSIS_JOINT
from sim.vehicle.drive import DriveConfig
from sim.vehicle.motion import Motion
from sim.vehicle.plan import SpeedPlan


class Stage:
    """Sets the scene for a picture at a time; times may be asked for in any order within the last second."""

    def __init__(self, scene: Scene, drive: DriveConfig) -> None:
        self._model, self._data = scene.model, mujoco.MjData(scene.model)
        self._cameras, self._traffic = scene.cameras, scene.traffic
        self._motion = Motion(drive, scene.route, scene.road, scene.car)
        car, physics = scene.model.joint(CHASSIS_JOINT), self._motion.model
        self._qpos = slice(car.qposadr[0], car.qposadr[0] + physics.nq)
        self._qvel = slice(car.dofadr[0], car.dofadr[0] + physics.nv)

    @property
    def motion(self) -> Motion:
        """The driven car, for sensors that need no picture."""
        return self._motion

    @property
    def plan(self) -> SpeedPlan:
        """Where the car means to be at any time, and how long the drive takes."""
        return self._motion.plan

    def at(self, time_s: float) -> mujoco.MjData:
        """Return positions and velocities at a time since the drive began; good until the next call."""
        state = self._motion.state_at(time_s)
        self._cameras.put(time_s)
        self._data.qpos[self._qpos], self._data.qvel[self._qvel] = state.qpos, state.qvel
        self._traffic.place(self._data, time_s)
        mujoco.mj_kinematics(self._model, self._data)
        mujoco.mj_comPos(self._model, self._data)
        mujoco.mj_camlight(self._model, self._data)
        mujoco.mj_comVel(self._model, self._data)
        return self._data
