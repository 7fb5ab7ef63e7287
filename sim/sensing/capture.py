"""All cameras of the car taking their images of one bundle: rendered views pass lens, shutter and sensor."""

from __future__ import annotations

from collections.abc import Mapping

from estimator.bundle import Image
from sim.rendering.view import Renderer, View
from sim.sensing.atmosphere import Atmosphere, ClearAir
from sim.sensing.development import Development
from sim.sensing.exposure import AutoExposure, ExposureControl, FixedExposure
from sim.sensing.face import GreyImage
from sim.sensing.lens import Lens
from sim.sensing.sensor import SensorConfig
from sim.sensing.shutter import Shutter, blur_s
from sim.sensing.sweep import Sweep
from sim.stage import Stage
from sim.vehicle.cameras import world_from_cam


class CameraArray:
    """The cameras of one drive. They remember how they exposed; noise is seeded by camera and bundle."""

    def __init__(
        self,
        lenses: Mapping[str, Lens],
        config: SensorConfig,
        seed: int,
        atmosphere: Atmosphere | None = None,
    ) -> None:
        self._lenses, self._config = lenses, config
        self._atmosphere: Atmosphere = atmosphere or ClearAir()
        self._developments = {
            name: Development(name, lens.size_px, config, seed) for name, lens in lenses.items()
        }
        controls: Mapping[str, type[ExposureControl]] = {"auto": AutoExposure, "fixed": FixedExposure}
        self._controls = {name: controls[config.exposure]() for name in lenses}
        self._sweep = Sweep(lenses, self._atmosphere)
        self._last_s: float | None = None

    def take(self, stage: Stage, renderer: Renderer, index: int, time_s: float) -> dict[str, Image]:
        """Return each camera's image of bundle ``index``, whose exposures are centred on ``time_s``.

        With a rolling shutter that is the middle row's. Bundles are taken in the order of their times.
        """
        lights = self._lights(stage, renderer, time_s)
        images = {}
        for name, light in lights.items():
            control = self._controls[name]
            images[name] = self._developments[name].on_sensor(light, control.now, index)
            control.watch(images[name])
        return images

    def _lights(self, stage: Stage, renderer: Renderer, time_s: float) -> dict[str, GreyImage]:
        """Return what falls on each sensor, once the exposure is set."""
        self._look_around(stage, renderer, time_s)
        lights = None
        if self._last_s is None:
            lights = self._through_lenses(self._still(stage, renderer, time_s), time_s)
            for name, light in lights.items():
                self._controls[name].settle(light)
        else:
            for control in self._controls.values():
                control.steer(time_s - self._last_s)
        self._last_s = time_s
        shutters = {name: self._shutter(control) for name, control in self._controls.items()}
        if any(not shutter.is_instant for shutter in shutters.values()):
            return self._through_lenses(self._sweep.take(stage, renderer, shutters, time_s), time_s)
        return lights or self._through_lenses(self._still(stage, renderer, time_s), time_s)

    def _shutter(self, control: ExposureControl) -> Shutter:
        return Shutter(self._config.rolling_shutter_s, blur_s(control.now, self._config.motion_blur))

    def _look_around(self, stage: Stage, renderer: Renderer, time_s: float) -> None:
        """Show the atmosphere what each camera sees in all, where it wants that."""
        data = stage.at(time_s)
        wanted = {
            name: self._atmosphere.around(lens.views(name, world_from_cam(data, name)))
            for name, lens in self._lenses.items()
        }
        views = {key: view for of_camera in wanted.values() for key, view in of_camera.items()}
        if not views:
            return
        pictures = renderer.render(data, views, depth=True)
        for name, of_camera in wanted.items():
            seen = [pictures[key] for key in of_camera]
            self._atmosphere.look_around(seen, list(of_camera.values()), name, time_s)

    def _still(self, stage: Stage, renderer: Renderer, time_s: float) -> dict[str, GreyImage]:
        """Return the light of one instant."""
        data = stage.at(time_s)
        views: dict[str, View] = {}
        for name, lens in self._lenses.items():
            views |= lens.views(name, world_from_cam(data, name))
        pictures = renderer.render(data, views, depth=self._atmosphere.needs_depth)
        return {
            name: lens.apply(
                [self._atmosphere.light(pictures[key], views[key], name, time_s) for key in lens.keys(name)]
            )
            for name, lens in self._lenses.items()
        }

    def _through_lenses(self, lights: Mapping[str, GreyImage], time_s: float) -> dict[str, GreyImage]:
        return {
            name: self._developments[name].through_lens(light, self._atmosphere, time_s)
            for name, light in lights.items()
        }
