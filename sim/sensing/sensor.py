"""What the image sensor adds: shot and read noise, and the final rounding to 8 bits."""

from __future__ import annotations

import numpy as np
from pydantic import Field

from estimator.bundle import Image
from estimator.config import Config
from sim.sensing.face import GreyImage

# A decent automotive sensor by day: 255 levels span about 10,000 electrons.
LEVELS_PER_ELECTRON = 255 / 10_000
READ_NOISE_LEVELS = 0.8


class SensorConfig(Config):
    """Sensor noise; 1 is a decent automotive sensor by day, 0 is none."""

    noise: float = Field(1.0, ge=0.0, le=20.0)


def expose(light: GreyImage, config: SensorConfig, rng: np.random.Generator) -> Image:
    """Turn (H, W) light, in levels 0 to 255 and fractions of them, into the 8-bit image a sensor gives.

    Shot noise is Gaussian with the variance of the Poisson law it stands for: true above some ten electrons.
    """
    if config.noise > 0:
        variance = light * np.float32(LEVELS_PER_ELECTRON) + np.float32(READ_NOISE_LEVELS**2)
        noise = rng.standard_normal(light.shape, dtype=np.float32)
        light = light + np.float32(config.noise) * np.sqrt(variance) * noise
    return np.asarray(np.clip(np.rint(light), 0, 255).astype(np.uint8))
