"""From an image's light to the image: what is on the lens, what the lens spoils, exposure, noise, JPEG.

Each effect has its own file, its own severity and its own generator; one that is off leaves no trace.
"""

from __future__ import annotations

import numpy as np

from estimator.bundle import Image
from sim.seeds import rng_for
from sim.sensing.atmosphere import Atmosphere
from sim.sensing.defocus import defocus, disc_kernel
from sim.sensing.dirt import splash
from sim.sensing.exposure import Exposure
from sim.sensing.face import GreyImage
from sim.sensing.jpeg import through_jpeg
from sim.sensing.sensor import SensorConfig, expose
from sim.sensing.vignetting import transmission


class Development:
    """One camera's way from light to image."""

    def __init__(self, camera: str, size_px: tuple[int, int], config: SensorConfig, seed: int) -> None:
        self._camera, self._config, self._seed = camera, config, seed
        self._kernel = disc_kernel(config.blur) if config.blur else None
        self._dirt = splash(size_px, config.dirt, self._rng("dirt")) if config.dirt else None
        self._passed = (
            transmission(size_px, config.vignetting, self._rng("vignetting")) if config.vignetting else None
        )

    def through_lens(self, light: GreyImage, atmosphere: Atmosphere, time_s: float) -> GreyImage:
        """Return what light of (H, W) falls on the sensor at a time."""
        if self._kernel is not None:
            light = defocus(light, self._kernel)
        light = atmosphere.cover(light, self._camera, time_s)
        if self._dirt is not None:
            light = self._dirt.over(light)
        return light if self._passed is None else light * self._passed

    def on_sensor(self, light: GreyImage, exposure: Exposure, index: int) -> Image:
        """Return the image that the sensor makes of the light that falls on it."""
        rng = rng_for(self._seed, f"sensor.{self._camera}.{index}")
        image = expose(light, self._config.noise, rng, exposure)
        return through_jpeg(image, self._config.jpeg) if self._config.jpeg else image

    def _rng(self, effect: str) -> np.random.Generator:
        return rng_for(self._seed, f"sensor.{effect}.{self._camera}")
