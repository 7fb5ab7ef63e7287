"""Three pictures in one: daylight, glow and albedo, a colour channel each, for places that lamps light too.

The cameras are grey, so where daylight is not all the light there is (dusk, night, tunnels) the three colour
channels carry what relighting needs. Red is the scene under the sky, shadows included; green is what glows by
itself; blue is the albedo under flat white light. Textures and colours are turned grey for that, and
``sim.light.daylight.write_lights`` lights each channel accordingly. Glow is stored as the root of its level,
since a window and a night sky are far apart.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import cv2
import mujoco
import numpy as np
import numpy.typing as npt

from sim.rendering.view import RgbImage

FloatImage = npt.NDArray[np.float32]
GlowImage = npt.NDArray[np.uint8]
_LUMA = np.array([0.299, 0.587, 0.114])  # ITU-R BT.601


@dataclass(frozen=True, eq=False)
class Channels:
    """A picture taken apart; each (H, W) float32 in levels of a sunny day."""

    day: FloatImage
    glow: FloatImage
    albedo: FloatImage


def split(picture: RgbImage) -> Channels:
    """Take the channels out of a picture of a world that went through ``write_channels``."""
    day, root, albedo = (channel.astype(np.float32) for channel in cv2.split(picture))
    return Channels(day, root * root * np.float32(1 / 255), albedo)


def stored_glow(level: Any) -> Any:
    """Return the texture value for a glow of some level, 0 to 255."""
    return np.sqrt(np.clip(level, 0.0, 255.0) * 255.0)


def write_channels(spec: mujoco.MjSpec, glows: Mapping[str, GlowImage]) -> None:
    """Turn every colour and texture of a finished spec, but the sky's, into channels.

    Args:
        spec: All of the world but its sky.
        glows: (H, W) level of the light that each texel sheds, by texture name; the others are dark.
    """
    for texture in spec.textures:
        if texture.type != mujoco.mjtTexture.mjTEXTURE_SKYBOX and texture.data:
            texture.data = _in_channels(texture, glows.get(texture.name)).tobytes()
    for material in spec.materials:
        textured = bool(material.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB])
        material.rgba = _grey_rgba(material.rgba, textured)
    for geom in spec.geoms:
        if not geom.material:
            geom.rgba = _grey_rgba(geom.rgba, False)


def _in_channels(texture: Any, glow: GlowImage | None) -> RgbImage:
    shape = (texture.height, texture.width, texture.nchannel)
    image = np.frombuffer(texture.data, np.uint8).reshape(shape)
    grey = cv2.cvtColor(image, cv2.COLOR_RGB2GRAY) if shape[2] == 3 else image[..., 0]
    root = np.zeros_like(grey) if glow is None else np.rint(stored_glow(glow)).astype(np.uint8)
    return np.dstack([grey, root, grey])


def _grey_rgba(rgba: Any, glows: bool) -> list[float]:
    grey = float(_LUMA @ np.asarray(rgba[:3]))
    return [grey, float(glows), grey, float(rgba[3])]
