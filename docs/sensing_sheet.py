"""Draw ``pictures/sensing.jpg``: what each effect of lens, shutter and sensor does, by severity.

``python -m docs.sensing_sheet`` writes it.
"""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np

from estimator.bundle import Image
from scenarios.load import load_scenario
from sim.rendering.classic import ClassicRenderer
from sim.scene import build_scene
from sim.sensing.capture import CameraArray
from sim.sensing.sensor import SensorConfig
from sim.stage import Stage

CAMERA, TIME_S = "left_front", 1.2
TILE_PX = (320, 200)
SEVERITIES = [0, 1, 2, 3, 4, 5]
# Values, and whether a part of the image is shown at full size rather than all of it at half.
EFFECTS: dict[str, tuple[list[float], bool]] = {
    "blur": (SEVERITIES, True),
    "motion_blur": (SEVERITIES, True),
    "rolling_shutter_s": ([0, 0.01, 0.02, 0.03, 0.04, 0.05], False),
    "vignetting": (SEVERITIES, False),
    "dirt": (SEVERITIES, False),
    "jpeg": (SEVERITIES, True),
    "noise": ([0, 1, 3, 6, 10, 20], True),
}


def main() -> None:
    scenario = load_scenario("first_drive", ["drive.speed_mps=8"])
    scene = build_scene(scenario.world, scenario.rig, 0)
    stage = Stage(scene, scenario.world.drive)
    rows = []
    with ClassicRenderer(scene.model) as renderer:
        for effect, (values, closely) in EFFECTS.items():
            tiles = []
            for value in values:
                config = SensorConfig(**{"noise": 1.0, "exposure": "fixed", effect: value})
                cameras = CameraArray({CAMERA: scene.lenses[CAMERA]}, config, 0)
                image = cameras.take(stage, renderer, 0, TIME_S)[CAMERA]
                tiles.append(labelled(tile(image, closely), f"{effect}: {value:g}"))
            rows.append(np.hstack(tiles))
    path = Path(__file__).parent / "pictures" / "sensing.jpg"
    path.parent.mkdir(exist_ok=True)
    cv2.imwrite(str(path), np.vstack(rows), [cv2.IMWRITE_JPEG_QUALITY, 85])


def tile(image: Image, closely: bool) -> Image:
    if closely:
        return image[100 : 100 + TILE_PX[1], 240 : 240 + TILE_PX[0]].copy()
    return np.asarray(cv2.resize(image, TILE_PX, interpolation=cv2.INTER_AREA))


def labelled(image: Image, text: str) -> Image:
    for level, width in ((0, 4), (255, 1)):
        cv2.putText(image, text, (6, 16), cv2.FONT_HERSHEY_SIMPLEX, 0.45, level, width, cv2.LINE_AA)
    return image


if __name__ == "__main__":
    main()
