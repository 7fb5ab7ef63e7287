"""The model's lights in pyrender's terms, in a fixed order: sets of objects would shuffle their sums."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np
import pyrender

from estimator.se3 import Array
from sim.rendering.linear_light import DIRECTIONAL, SPOT, lamp_light, shines
from sim.rendering.quality import SHADOW_RADIUS_M

_RADIANCE_OF_WHITE = np.pi / 0.96  # its plain materials throw back 96 % of diffuse light
_SUN_DISTANCE_M = 150.0
_SUN_NEAR_M, _SUN_FAR_M = 50.0, 250.0  # narrow, for its bias against self-shadowing is a share of this


class Sun(pyrender.DirectionalLight):  # type: ignore[misc]
    """A directional light whose shadow map covers a fixed radius, however large the scene."""

    def __init__(self, map_px: int) -> None:
        super().__init__()
        self._map_px = map_px

    def _generate_shadow_texture(self, size: int | None = None) -> None:
        super()._generate_shadow_texture(self._map_px)

    def _get_shadow_camera(self, scene_scale: float) -> Any:
        return pyrender.OrthographicCamera(SHADOW_RADIUS_M, SHADOW_RADIUS_M, _SUN_NEAR_M, _SUN_FAR_M)


class PyrenderLights:
    """The lights of one scene; follows their poses, colours and switches in the model."""

    def __init__(self, model: mujoco.MjModel, map_px: int) -> None:
        self._model = model
        self.nodes: dict[int, Any] = {
            index: pyrender.Node(light=_make(model, index, map_px))
            for index in range(model.nlight)
            if shines(model, index)
        }

    def update(self, data: mujoco.MjData, middle_m: Array) -> None:
        """Follow the model and its state; the sun's shadows are those around ``middle_m``."""
        for index, node in self.nodes.items():
            color = _RADIANCE_OF_WHITE * lamp_light(self._model, index)
            node.light.intensity = max(float(color.max()), 1e-9)
            node.light.color = color / node.light.intensity
            toward = data.light_xdir[index]
            directional = self._model.light_type[index] == DIRECTIONAL
            position = middle_m - _SUN_DISTANCE_M * toward if directional else data.light_xpos[index]
            node.matrix = _looking(toward, position)


def _make(model: mujoco.MjModel, index: int, map_px: int) -> Any:
    if model.light_type[index] == DIRECTIONAL:
        return Sun(map_px)
    if model.light_type[index] == SPOT:
        outer_rad = float(np.radians(min(model.light_cutoff[index], 89.0)))
        return pyrender.SpotLight(innerConeAngle=outer_rad / 2, outerConeAngle=outer_rad)
    return pyrender.PointLight()


def _looking(toward: Array, position: Array) -> Array:
    """Return the (4, 4) pose whose -z axis points along a direction."""
    back = -toward / np.linalg.norm(toward)
    right = np.cross([0.0, 0.0, 1.0] if abs(back[2]) < 0.9 else [1.0, 0.0, 0.0], back)
    right /= np.linalg.norm(right)
    pose = np.eye(4)
    pose[:3] = np.column_stack([right, np.cross(back, right), back, position])
    return pose
