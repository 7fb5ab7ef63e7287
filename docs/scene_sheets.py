"""Draw pictures of streets, traffic, vehicle and renderers: ``python -m docs.scene_sheets [NAME ...]``."""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from estimator.camera import Camera
from estimator.se3 import SE3
from eval.lettering import text_width_px, write_text
from scenarios.load import load_scenario
from sim.rendering.choice import RENDERER_NAMES, open_renderer
from sim.rendering.names import RendererName
from sim.rendering.view import View
from sim.scene import build_scene
from sim.stage import Stage
from sim.vehicle.cameras import world_from_cam
from sim.vehicle.car_state import world_from_ego

PICTURES = Path(__file__).parent / "pictures"
_TEXT_PX = 12
_BEHIND = SE3(np.array([[0, 0, 1.0], [-1, 0, 0], [0, -1, 0]]), np.array([-6.5, 0.0, 1.2]))
_BESIDE = SE3(np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]]), np.array([1.2, -5.2, 0.9]))  # looks to the left


@dataclass(frozen=True)
class Shot:
    """One picture: a scenario with settings, seen by a camera of the rig, or from a pose in the ego frame."""

    scenario: str
    settings: tuple[str, ...] = ()
    seed: int = 1
    time_s: float = 2.0
    camera: str | SE3 = "front"
    caption: str = ""
    renderer: RendererName = "classic"

    def draw(self, size_px: tuple[int, int]) -> Any:
        scenario = load_scenario(self.scenario, list(self.settings))
        scene = build_scene(scenario.world, scenario.rig, self.seed)
        data = Stage(scene, scenario.world.drive).at(self.time_s)
        if isinstance(self.camera, SE3):
            pose = world_from_ego(data) @ self.camera
        else:
            pose = world_from_cam(data, self.camera)
        width, height = size_px
        pinhole = Camera("pinhole", size_px, (0.6 * width, 0.6 * width), ((width - 1) / 2, (height - 1) / 2))
        with open_renderer(self.renderer, scene.model) as renderer:
            picture = renderer.render(data, {"eye": View(pinhole, pose)})["eye"].rgb[..., ::-1].copy()
        if self.caption:
            right_px = 14 + text_width_px(self.caption, _TEXT_PX)
            cv2.rectangle(picture, (0, height - 22), (right_px, height), (30, 30, 30), -1)
            write_text(picture, self.caption, (7, height - 7), _TEXT_PX, (255, 255, 255))
        return picture


def _street(kind: str, *settings: str) -> Shot:
    caption = ", ".join((kind, *(setting.removeprefix("street.") for setting in settings)))
    length = "street.length_m=130"
    return Shot("first_drive", (f"street.kind={kind}", length, *settings), caption=caption)


_SCENERY = (
    "urban_bend",
    "crossroads",
    "roundabout",
    "motorway",
    "tunnel",
    "car_park",
    "bare_suburb",
    "repeated_facades",
    "block_loop",
)
_ALONE = ("street.parking=0", "street.traffic={cars: 0, cyclists: 0, pedestrians: 0}")
# By file: columns, size of a tile, shots.
SHEETS: dict[str, tuple[int, tuple[int, int], list[Shot]]] = {
    "streets": (
        3,
        (360, 225),
        [
            *map(_street, ("straight", "bend", "t_junction", "crossroads", "roundabout")),
            Shot("block_loop", caption="loop"),
            *map(_street, ("motorway", "tunnel", "car_park")),
            _street("suburb", "street.facades=bare"),
            _street("canyon", "street.facades=repeated"),
            _street("straight", "street.slope_percent=12", "street.speed_bumps=5"),
        ],
    ),
    "street_scenery": (
        3,
        (430, 269),
        [Shot(name, ("weather.tunnel=0",), seed=2, time_s=3.0) for name in _SCENERY],
    ),
    "traffic": (
        3,
        (480, 300),
        [
            Shot("traffic_jam", time_s=3.0),
            Shot("dense_traffic", time_s=3.0),
            Shot("busy_pavements", ("street.parking=0",), time_s=2.0, camera="right_rear"),
            Shot("cyclists_close_by", time_s=2.0, camera="right_front"),
            Shot("traffic_jam", seed=2, time_s=4.0, camera="left_rear"),
            Shot("cyclists_close_by", time_s=1.0, camera="right_rear"),
        ],
    ),
    "vehicle": (
        3,
        (400, 250),
        [
            Shot("hard_braking", _ALONE, 0, 1.0, _BESIDE, "cruising"),
            Shot("hard_braking", _ALONE, 0, 3.2, _BESIDE, "braking hard"),
            Shot("roundabout", (*_ALONE, "drive.lateral_mps2=6"), 0, 4.2, _BEHIND, "leaning in a turn"),
        ],
    ),
    "renderers": (
        2,
        (384, 240),
        [
            Shot("first_drive", seed=0, time_s=1.0, camera=camera, caption=name, renderer=name)
            for name in RENDERER_NAMES
            for camera in ("front", "right_front")
        ],
    ),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", default=list(SHEETS))
    for name in parser.parse_args().names:
        columns, size_px, shots = SHEETS[name]
        tiles = [shot.draw(size_px) for shot in shots]
        rows = [np.hstack(tiles[first : first + columns]) for first in range(0, len(tiles), columns)]
        cv2.imwrite(str(PICTURES / f"{name}.jpg"), np.vstack(rows), [cv2.IMWRITE_JPEG_QUALITY, 88])


if __name__ == "__main__":
    main()
