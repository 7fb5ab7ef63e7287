"""How actors speed up, slow down, and how fast the traffic as a whole lets them go."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array

_WAVE_M, _WAVE_S = 90.0, 24.0  # stop-and-go waves: length, and time until the next one


@dataclass(frozen=True)
class Pace:
    """The kinematics of one kind of actor.

    Attributes:
        push_mps2: Strongest acceleration.
        brake_mps2: Strongest braking.
        gap_m: To the one ahead at a standstill.
        step_s: Of simulated time.
        jam: How far stop-and-go waves have grown, 0 to 1.
    """

    push_mps2: float
    brake_mps2: float
    gap_m: float
    step_s: float
    jam: float = 0.0

    @property
    def _last_step_m(self) -> float:
        """What the last step of a stop may take more than braking at full strength would."""
        return self.brake_mps2 * self.step_s**2 / 8

    def stopping_m(self, speed_mps: float) -> float:
        """Way to stop, if the brake is hit one step from now and acceleration goes on until then."""
        later = speed_mps + self.push_mps2 * self.step_s
        return (speed_mps + later) / 2 * self.step_s + later**2 / (2 * self.brake_mps2)

    def next_speed(self, speed_mps: Array, limit_mps: Array, free_m: Array) -> Array:
        """Return the speeds one step on: never so fast that ``free_m`` would not do to stop.

        Speed changes linearly within the step. If ``free_m`` sufficed to stop before, it does so after.
        """
        brake, step = self.brake_mps2, self.step_s
        rest = np.maximum(free_m - self._last_step_m - speed_mps * step / 2, 0.0)
        safe = np.sqrt((brake * step / 2) ** 2 + 2 * brake * rest) - brake * step / 2
        eased = np.maximum(limit_mps, speed_mps - 0.75 * brake * step)
        return np.asarray(
            np.maximum(np.minimum.reduce([speed_mps + self.push_mps2 * step, eased, safe]), 0.0)
        )

    def wave(self, way_m: Array, phase: Array, time_s: float) -> Array:
        """Share of the lane's speed that the traffic allows; slow stretches wander back through a jam."""
        if self.jam == 0.0:
            return np.ones(len(way_m))
        crest = 0.5 + 0.5 * np.sin(2 * np.pi * (way_m / _WAVE_M + time_s / _WAVE_S) + 1.7 * phase)
        return np.asarray(1.0 - self.jam * (0.35 + 0.65 * crest**2))
