"""The model's lights in Filament's terms: a sun with shadows, lamps in candela, the sky as ambient light."""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np

from sim.rendering.linear_light import DIRECTIONAL, GAMMA, SPOT, lamp_light, shines, sky_light
from sim.rendering.sky_texture import skybox_of
from sim.rendering.view import RgbImage

_NITS_OF_WHITE = 20_400.0  # what MuJoCo's exposure of Filament shows as 1, found with a white wall
_LUX_OF_WHITE = np.pi * _NITS_OF_WHITE
_SKY_SIDE_PX = 4  # of a cube with one colour
_SUN_RADIUS = 0.02  # softness of its shadows


class FilamentLights:
    """The lights of one scene; follows their poses, colours and switches in the model."""

    def __init__(self, mjrf: Any, context: Any, scene: Any, model: mujoco.MjModel, shadow_px: int) -> None:
        self._mjrf, self._context, self._model = mjrf, context, model
        self._sky = _add_sky(mjrf, context, scene, model)  # kept alive
        self._lights = {
            index: self._make(index, shadow_px) for index in range(model.nlight) if shines(model, index)
        }
        for light in self._lights.values():
            scene.add_light(light)

    def update(self, data: mujoco.MjData) -> None:
        """Follow the model and its state."""
        for index, light in self._lights.items():
            color = lamp_light(self._model, index)
            brightest = float(color.max())
            light.set_active(brightest > 0)
            if brightest > 0:
                light.set_color((color / brightest).astype(np.float32))
                light.set_intensity(brightest * _LUX_OF_WHITE)
            light.set_pose(
                data.light_xpos[index].astype(np.float32), data.light_xdir[index].astype(np.float32)
            )

    def _make(self, index: int, shadow_px: int) -> Any:
        model, kinds = self._model, self._mjrf.LightType
        kind = {DIRECTIONAL: kinds.LIGHT_DIRECTIONAL, SPOT: kinds.LIGHT_SPOT}.get(
            int(model.light_type[index]), kinds.LIGHT_POINT
        )
        parameters = self._mjrf.LightParams(
            type=kind,
            cast_shadow=bool(model.light_castshadow[index]) and shadow_px > 0,
            range=float(model.light_range[index]),
            cutoff=float(model.light_cutoff[index]),
            shadow_map_size=max(shadow_px, 1),
            bulb_radius=_SUN_RADIUS,
        )
        return self._context.create_light(parameters)


def _add_sky(mjrf: Any, context: Any, scene: Any, model: mujoco.MjModel) -> Any:
    """Add the skybox, and its even light from all around; return what must be kept alive."""
    display = sky_light(model) ** (1 / GAMMA)
    even = np.rint(255 * np.broadcast_to(display, (6 * _SKY_SIDE_PX, _SKY_SIDE_PX, 3))).astype(np.uint8)
    around = _cube(mjrf, context, even, mjrf.SamplerType.TEXTURE_CUBE)
    kind = mjrf.LightType.LIGHT_IMAGE
    light = context.create_light(mjrf.LightParams(type=kind, texture=around, intensity=_NITS_OF_WHITE))
    scene.add_light(light)
    faces = skybox_of(model)
    if faces is None:
        return around, light
    sky = _cube(mjrf, context, faces, mjrf.SamplerType.TEXTURE_SKYBOX)
    scene.set_skybox(sky)
    return around, light, sky


def _cube(mjrf: Any, context: Any, faces: RgbImage, sampler: Any) -> Any:
    height, width, _ = faces.shape
    config = mjrf.TextureConfig(
        width=width,
        height=height,
        format=mjrf.PixelFormat.PIXEL_FORMAT_RGB8,
        color_space=mjrf.ColorSpace.COLORSPACE_SRGB,
        sampler_type=sampler,
    )
    texture, pixels = context.create_texture(config), mjrf.TextureData()
    pixels.set_image(np.ascontiguousarray(faces).tobytes())
    texture.upload(pixels)
    return texture
