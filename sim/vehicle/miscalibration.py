"""Seeded errors of the cameras' mounting, constant and changing: what the estimator has to find."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from pydantic import Field

from estimator.config import Config
from estimator.rig import Rig
from estimator.se3 import SE3, Array
from sim.seeds import rng_for
from sim.vehicle.mount_events import PHASES, AnyMountEvent, MountEvent, check_events


class MiscalibrationConfig(Config):
    """Exact size of every camera's error: an angle about a random axis, a length in a random direction.

    ``events`` come on top of it while the car drives.
    """

    rotation_deg: float = Field(3.0, ge=0.0, le=30.0)
    translation_mm: float = Field(100.0, ge=0.0, le=1000.0)
    events: list[AnyMountEvent] = Field([])


def miscalibrate(nominal: Rig, config: MiscalibrationConfig, seed: int) -> dict[str, SE3]:
    """Return every camera's ``ego_from_cam`` without events: nominal for the reference, off else.

    A camera's error depends on the seed and its own name only, so adding a camera moves no other.
    """
    true = {nominal.reference: nominal[nominal.reference].ego_from_cam}
    for name in nominal.estimated_names:
        rng = rng_for(seed, f"miscalibration.{name}")
        omega = np.deg2rad(config.rotation_deg) * _random_direction(rng)
        shift_m = config.translation_mm / 1000 * _random_direction(rng)
        true[name] = _moved(nominal[name].ego_from_cam, omega, shift_m)
    return {name: true[name] for name in nominal.cameras}


@dataclass(frozen=True, eq=False)
class Movement:
    """An event and the directions one camera moves in: (3,) rotation in the camera's axes, shift in ego's."""

    event: MountEvent
    omega_rad: Array
    shift_m: Array
    phases: tuple[float, ...]


@dataclass(frozen=True, eq=False)
class Mounts:
    """The cameras whose mounting changes during a drive.

    Attributes:
        starting: ``ego_from_cam`` without events, by camera; only of those that move.
        movements: By camera.
    """

    starting: Mapping[str, SE3]
    movements: Mapping[str, Sequence[Movement]]

    def moved(self, camera: str, time_s: float) -> SE3 | None:
        """Return a camera's ``ego_from_cam`` at a time; None where it is exactly the starting one."""
        shares = [(each, each.event.share(time_s, each.phases)) for each in self.movements[camera]]
        if not any(share for _, share in shares):
            return None
        pose = self.starting[camera]
        for each, share in shares:
            pose = _moved(pose, share * each.omega_rad, share * each.shift_m)
        return pose


STEADY = Mounts({}, {})


def moving_mounts(nominal: Rig, config: MiscalibrationConfig, seed: int) -> Mounts:
    """Return what the events do to the cameras; raises InputError for a camera they cannot move."""
    check_events(config.events, nominal)
    movements = {
        name: [
            _movement(event, rng_for(seed, f"miscalibration.{name}.event.{index}"))
            for index, event in enumerate(config.events)
            if event.concerns(name)
        ]
        for name in nominal.estimated_names
    }
    movements = {name: several for name, several in movements.items() if several}
    starting = miscalibrate(nominal, config, seed)
    return Mounts({name: starting[name] for name in movements}, movements)


def _movement(event: MountEvent, rng: np.random.Generator) -> Movement:
    omega_rad = np.deg2rad(event.rotation_deg) * _random_direction(rng)
    shift_m = event.translation_mm / 1000 * _random_direction(rng)
    return Movement(event, omega_rad, shift_m, tuple(rng.random(PHASES).tolist()))


def _moved(ego_from_cam: SE3, omega_rad: Array, shift_m: Array) -> SE3:
    rotation = ego_from_cam.rotation @ SE3.exp(np.concatenate([omega_rad, np.zeros(3)])).rotation
    return SE3(rotation, ego_from_cam.translation + shift_m)


def _random_direction(rng: np.random.Generator) -> Array:
    direction = rng.standard_normal(3)
    return np.asarray(direction / np.linalg.norm(direction))
