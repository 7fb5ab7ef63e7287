"""Seeded errors of the cameras' mounting: what the estimator has to find."""

from __future__ import annotations

import numpy as np
from pydantic import Field

from estimator.config import Config
from estimator.rig import Rig
from estimator.se3 import SE3, Array
from sim.seeds import rng_for


class MiscalibrationConfig(Config):
    """Exact size of every camera's error: an angle about a random axis, a length in a random direction."""

    rotation_deg: float = Field(3.0, ge=0.0, le=30.0)
    translation_mm: float = Field(100.0, ge=0.0, le=1000.0)


def miscalibrate(nominal: Rig, config: MiscalibrationConfig, seed: int) -> dict[str, SE3]:
    """Return every camera's true ``ego_from_cam``: nominal for the reference, off by the stated sizes else.

    A camera's error depends on the seed and its own name only, so adding a camera moves no other.
    """
    true = {nominal.reference: nominal[nominal.reference].ego_from_cam}
    for name in nominal.estimated_names:
        rng = rng_for(seed, f"miscalibration.{name}")
        omega = np.deg2rad(config.rotation_deg) * _random_direction(rng)
        shift_m = config.translation_mm / 1000 * _random_direction(rng)
        ego_from_cam = nominal[name].ego_from_cam
        rotation = ego_from_cam.rotation @ SE3.exp(np.concatenate([omega, np.zeros(3)])).rotation
        true[name] = SE3(rotation, ego_from_cam.translation + shift_m)
    return {name: true[name] for name in nominal.cameras}


def _random_direction(rng: np.random.Generator) -> Array:
    direction = rng.standard_normal(3)
    return np.asarray(direction / np.linalg.norm(direction))
