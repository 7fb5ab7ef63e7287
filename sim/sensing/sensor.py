"""The settings of lens, shutter and sensor, and what the sensor adds: noise and the rounding to 8 bits."""

from __future__ import annotations

from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from estimator.bundle import Image
from estimator.camera import CameraModel
from estimator.config import Config
from sim.sensing.exposure import Exposure
from sim.sensing.face import GreyImage

# A decent automotive sensor by day: 255 levels span about 10,000 electrons.
LEVELS_PER_ELECTRON = 255 / 10_000
READ_NOISE_LEVELS = 0.8  # at gain 1
_AMPLIFIED_READ_NOISE_LEVELS = 0.2  # the part of it, 8 electrons, that comes before the gain

Severity = Annotated[float, Field(ge=0.0, le=5.0)]


class SensorConfig(Config):
    """Lens, shutter and sensor of all cameras; severities are 0 (off) to 5.

    ``noise`` 1 is a decent automotive sensor by day. ``rolling_shutter_s`` is the time from the exposure of
    an image's first row to that of its last. ``lens`` other than ``nominal`` gives every camera of the rig
    that model, in the estimator's rig file as well.
    """

    noise: float = Field(1.0, ge=0.0, le=20.0)
    blur: Severity = 0.0
    motion_blur: Severity = 0.0
    vignetting: Severity = 0.0
    dirt: Severity = 0.0
    jpeg: Severity = 0.0
    exposure: Literal["auto", "fixed"] = "auto"
    lens: Literal["nominal"] | CameraModel = "nominal"
    rolling_shutter_s: float = Field(0.0, ge=0.0, le=0.05)


def expose(
    light: GreyImage, noise: float, rng: np.random.Generator, exposure: Exposure | None = None
) -> Image:
    """Turn (H, W) light into the 8-bit image a sensor gives.

    Light is in levels of a sunny day, 0 to 255 and beyond. Shot noise is Gaussian with the variance of the
    Poisson law it stands for: true above some ten electrons. It follows the electrons collected, so that gain
    raises it.

    Args:
        light: What falls on the sensor.
        noise: Factor on the noise's standard deviation; 1 is a decent automotive sensor.
        rng: Of this image.
        exposure: A sunny day's if None.
    """
    exposure = exposure or Exposure()
    if exposure.scale != 1:
        light = light * np.float32(exposure.scale)
    if noise > 0:
        variance = light * np.float32(LEVELS_PER_ELECTRON * exposure.gain)
        variance += np.float32(_read_variance(exposure.gain))
        spread = np.float32(noise) * np.sqrt(np.maximum(variance, 0))  # a sharp lens undershoots zero
        light = light + spread * rng.standard_normal(light.shape, np.float32)
    return np.asarray(np.clip(np.rint(light), 0, 255).astype(np.uint8))


def _read_variance(gain: float) -> float:
    return READ_NOISE_LEVELS**2 + (gain**2 - 1) * _AMPLIFIED_READ_NOISE_LEVELS**2
