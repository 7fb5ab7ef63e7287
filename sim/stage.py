"""The world at any instant: car, cameras and whatever else moves, put where they are at that time."""

from __future__ import annotations

import mujoco

from sim.scene import Scene
from sim.vehicle.drive import DriveConfig
from sim.vehicle.motion import Motion


class Stage:
    """Sets the scene for a picture at a time; times may be asked for in any order within the last second."""

    def __init__(self, scene: Scene, drive: DriveConfig) -> None:
        self._model, self._data = scene.model, mujoco.MjData(scene.model)
        self._motion = Motion(scene.model, drive, scene.path_m, scene.car)

    def at(self, time_s: float) -> mujoco.MjData:
        """Return positions and velocities at a time since the drive began; good until the next call."""
        state = self._motion.state_at(time_s)
        self._data.qpos[:], self._data.qvel[:] = state.qpos, state.qvel
        mujoco.mj_kinematics(self._model, self._data)
        mujoco.mj_comPos(self._model, self._data)
        mujoco.mj_camlight(self._model, self._data)
        mujoco.mj_comVel(self._model, self._data)
        return self._data
