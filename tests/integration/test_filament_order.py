"""Filament draws what ties in depth the same way in every context.

Roofs of the street below go through each other, and at a few pixels they tie; left to itself, every other
context let another one win.
"""

import numpy as np
import pytest

from scenarios.load import load_scenario
from sim.rendering.choice import open_renderer, probe
from sim.scene import build_scene
from sim.stage import Stage
from sim.vehicle.cameras import world_from_cam

CONTEXTS = 8  # without an order of its own a half of them came out either way


def test_every_context_draws_the_same_where_roofs_meet() -> None:
    if problem := probe("filament").problem:
        pytest.skip(f"no Filament here: {problem}")
    scenario = load_scenario("filament_street")
    scene = build_scene(scenario.world, scenario.rig, seed=0)
    data = Stage(scene, scenario.world.drive).at(0.0)
    views = scene.lenses["left_front"].views("left_front", world_from_cam(data, "left_front"))
    pictures = []
    for _ in range(CONTEXTS):
        with open_renderer("filament", scene.model) as renderer:
            pictures.append(renderer.render(data, views)["left_front"].rgb.astype(int))
    assert [np.abs(picture - pictures[0]).max() for picture in pictures] == [0] * CONTEXTS
