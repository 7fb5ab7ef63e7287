"""What light and weather cost: ``python -m tests.benchmark.weather_costs`` prints the table of the docs.

CPU time of this process (``time.process_time``), the least of several goes, for a bundle of seven images of
``first_drive``; what rendering it costs, with depth and without, is told beside it. Relighting and air are
timed on pictures that are there already, drops and flare on images that are.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable

import cv2

from scenarios.load import load_scenario
from sim.light.on_board import OnBoardAtmosphere
from sim.rendering.classic import ClassicRenderer
from sim.rendering.view import View
from sim.scene import build_scene
from sim.stage import Stage
from sim.vehicle.cameras import world_from_cam

_CARS = "street.traffic.cars=3"
WEATHERS: dict[str, tuple[str, ...]] = {
    "a plain day": (),
    "fog 3": ("weather.fog=3",),
    "rain 4": ("weather.rain=4",),
    "dusk 4": ("weather.dusk=4",),
    "night 1": ("weather.night=1",),
    "night 3": ("weather.night=3",),
    "night 3 in dense traffic": ("weather.night=3", _CARS),
    "night 2, fog 3": ("weather.night=2", "weather.fog=3"),
    "night 3, rain 3, wet_lens 2": ("weather.night=3", "weather.rain=3", "weather.wet_lens=2"),
    "wet_lens 3": ("weather.wet_lens=3",),
    "wet_lens 5": ("weather.wet_lens=5",),
    "flare 3": ("weather.flare=3", "weather.sun_elevation_deg=17", "weather.sun_azimuth_deg=8"),
}
_GOES, _AT_S = 3, 2.0


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("weathers", nargs="*", metavar="WEATHER", help="; ".join(WEATHERS))
    chosen = parser.parse_args().weathers or list(WEATHERS)
    if unknown := set(chosen) - set(WEATHERS):
        parser.error(f"no weather {', '.join(sorted(unknown))}; there are: {'; '.join(WEATHERS)}")
    cv2.setNumThreads(1)
    print(f"{'CPU ms a bundle':<32}{'weather':>9}{'rendering':>11}{'Mpx':>7}")
    for name in chosen:
        spent_ms, rendering_ms, pixels = cost(WEATHERS[name])
        print(f"{name:<32}{spent_ms:>9.0f}{rendering_ms:>11.0f}{pixels / 1e6:>7.2f}", flush=True)


def cost(settings: tuple[str, ...]) -> tuple[float, float, int]:
    """Return CPU ms of a bundle for its weather and for rendering it, and how many pixels are rendered."""
    scenario = load_scenario("first_drive", settings)
    scene = build_scene(scenario.world, scenario.rig, 0)
    stage = Stage(scene, scenario.world.drive)
    assert scene.atmosphere is not None
    air = OnBoardAtmosphere(scene.atmosphere, scene.model, stage.at, scene.traffic)
    data = stage.at(_AT_S)
    views: dict[str, View] = {}
    for name, lens in scene.lenses.items():
        views |= lens.views(name, world_from_cam(data, name))
    keys = {name: lens.keys(name) for name, lens in scene.lenses.items()}
    around = {name: air.around({key: views[key] for key in of_lens}) for name, of_lens in keys.items()}
    around = {name: of_camera for name, of_camera in around.items() if of_camera}  # only wet roads mirror
    with ClassicRenderer(scene.model) as renderer:
        pictures = renderer.render(data, views, depth=air.needs_depth)
        rendering_ms = least_ms(lambda: renderer.render(data, views, depth=air.needs_depth))
        wide = {name: renderer.render(data, of_camera, depth=True) for name, of_camera in around.items()}

    def look_around() -> None:
        for name, of_camera in around.items():
            air.look_around(list(wide[name].values()), list(of_camera.values()), name, _AT_S)

    look_around()
    lit = {
        name: [air.light(pictures[key], views[key], name, _AT_S) for key in of_lens]
        for name, of_lens in keys.items()
    }
    images = {name: lens.apply(lit[name]) for name, lens in scene.lenses.items()}

    def bundle() -> None:
        look_around()
        for name, of_lens in keys.items():
            for key in of_lens:
                air.light(pictures[key], views[key], name, _AT_S)
            air.cover(images[name], name, _AT_S)

    return least_ms(bundle), rendering_ms, sum(picture.rgb[..., 0].size for picture in pictures.values())


def least_ms(work: Callable[[], object]) -> float:
    """Return the CPU milliseconds of the quickest go."""
    spent_s = []
    for _ in range(_GOES):
        started_s = time.process_time()
        work()
        spent_s.append(time.process_time() - started_s)
    return 1000 * min(spent_s)


if __name__ == "__main__":
    main()
