"""All cameras of the car taking their images of one bundle: views are rendered, then pass lens and sensor."""

from __future__ import annotations

from collections.abc import Mapping

import cv2
import numpy as np

from estimator.bundle import Image
from sim.rendering.view import Renderer, RgbImage, View
from sim.seeds import rng_for
from sim.sensing.face import GreyImage
from sim.sensing.lens import Lens
from sim.sensing.sensor import SensorConfig, expose
from sim.stage import Stage
from sim.vehicle.cameras import world_from_cam

_LUMA = np.array([[0.299, 0.587, 0.114]], np.float32)  # ITU-R BT.601


class CameraArray:
    """The cameras of one drive; noise is seeded by camera and bundle."""

    def __init__(self, lenses: Mapping[str, Lens], config: SensorConfig, seed: int) -> None:
        self._lenses, self._config, self._seed = lenses, config, seed

    def take(self, stage: Stage, renderer: Renderer, index: int, time_s: float) -> dict[str, Image]:
        """Return each camera's image of bundle ``index``, whose exposures are centred on ``time_s``."""
        data = stage.at(time_s)
        views: dict[str, View] = {}
        for name, lens in self._lenses.items():
            views |= lens.views(name, world_from_cam(data, name))
        pictures = renderer.render(data, views)
        return {
            name: expose(
                lens.apply([grey(pictures[key].rgb) for key in lens.keys(name)]),
                self._config,
                rng_for(self._seed, f"sensor.{name}.{index}"),
            )
            for name, lens in self._lenses.items()
        }


def grey(picture: RgbImage) -> GreyImage:
    """Return (H, W) luma of an (H, W, 3) picture, unrounded."""
    return np.asarray(cv2.transform(picture.astype(np.float32), _LUMA))
