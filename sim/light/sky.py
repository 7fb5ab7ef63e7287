"""The sky: haze, blue, clouds, the sun's disc and its aureole, dusk's glow, and a town's glow at night."""

from __future__ import annotations

import cv2
import mujoco
import numpy as np

from estimator.se3 import Array
from sim.light.channels import stored_glow
from sim.light.daylight import Daylight
from sim.paint.noise import fractal, smoothstep

SUN_RADIUS_DEG = 0.35  # as a lens and a little haze show it
_FACE_PX = 512
_HAZE, _ZENITH = np.array([238.0, 239.0, 240.0]), np.array([128.0, 164.0, 210.0])
_CLOUD, _GREY_HIGH, _GREY_LOW = 246.0, 214.0, 246.0
_TOWN_GLOW, _NIGHT_ZENITH = 0.7, 0.12  # levels of a clear night over a town


def write_sky(
    spec: mujoco.MjSpec, daylight: Daylight, night: float, in_channels: bool, rng: np.random.Generator
) -> None:
    """Add the skybox.

    Args:
        spec: The world.
        daylight: What is up there.
        night: How far the night has come, 0 to 1.
        in_channels: Whether to store it as ``sim.light.channels`` does.
        rng: Draws the clouds.
    """
    clouds = fractal(rng, (_FACE_PX, 2 * _FACE_PX), (_FACE_PX / 5, _FACE_PX / 3), 7, 0.55)
    rays = sky_rays(_FACE_PX)
    faces = sky_colors(rays, daylight, clouds)
    if in_channels:
        grey = faces @ np.array([0.299, 0.587, 0.114])
        glow = stored_glow(night_glow(rays, clouds) * night)
        glow = glow + night * rng.uniform(
            -0.5, 0.5, glow.shape
        )  # else it ends in steps that long exposures show
        faces = np.stack([grey, glow, np.zeros_like(grey)], axis=-1)
    texture = spec.add_texture(
        name="sky",
        type=mujoco.mjtTexture.mjTEXTURE_SKYBOX,
        width=_FACE_PX,
        height=6 * _FACE_PX,
        nchannel=3,
    )
    texture.data = np.rint(np.clip(faces, 0, 255)).astype(np.uint8).tobytes()


def sky_rays(size: int) -> Array:
    """Return the (6 size, size, 3) unit world directions of a skybox's texels.

    Its faces are right, left, up, down, front, back of a cube in OpenGL's frame, one above the other. What is
    x, y, z there is x, z, -y in the world: found by rendering, and held by a test.
    """
    steps = (np.arange(size) + 0.5) / size * 2 - 1
    u, v = np.meshgrid(steps, steps)
    one = np.ones_like(u)
    cube = [(one, -v, -u), (-one, -v, u), (u, one, v), (u, -one, -v), (u, -v, one), (-u, -v, -one)]
    rays = np.vstack([np.stack([x, -z, y], axis=-1) for x, y, z in cube])
    return np.asarray(rays / np.linalg.norm(rays, axis=-1, keepdims=True))


def sky_colors(rays: Array, daylight: Daylight, clouds: Array) -> Array:
    """Return the sky's colours, in levels before ``daylight.level`` dims them.

    Args:
        rays: (..., 3) unit world directions.
        daylight: Sun, clouds, dusk.
        clouds: (H, W) noise of unit deviation, the ceiling of clouds.
    """
    rise = np.clip(rays[..., 2], 0.0, 1.0)[..., None]
    noise = _on_ceiling(rays, clouds)
    above_haze = smoothstep(0.04, 0.2, rays[..., 2])
    to_sun_deg = np.degrees(np.arccos(np.clip(rays @ daylight.toward_sun, -1.0, 1.0)))[..., None]
    clear = _HAZE + (_ZENITH - _HAZE) * rise**0.55
    clear = clear + 14.0 * np.exp(-to_sun_deg / 8.0) * daylight.sun
    cover = 0.85 * (smoothstep(0.0, 1.2, noise) * above_haze)[..., None]
    clear = clear + (_CLOUD - clear) * cover
    clear = clear + daylight.dusk * (_dusk(rays, rise, daylight, cover) - clear)
    grey = _GREY_LOW + (_GREY_HIGH - _GREY_LOW) * rise + 7.0 * (noise * above_haze)[..., None]
    color = clear + daylight.grey**0.7 * (grey - clear)
    disc = smoothstep(SUN_RADIUS_DEG + 0.1, SUN_RADIUS_DEG - 0.1, to_sun_deg) + 0.6 * np.exp(
        -to_sun_deg / 1.2
    )
    return np.asarray(color + (255.0 - color) * np.minimum(1.0, disc * min(1.0, 3.0 * daylight.sun)))


def night_glow(rays: Array, clouds: Array) -> Array:
    """Return the level of a town's glow, on haze and clouds, by direction."""
    low = np.exp(-np.clip(rays[..., 2], 0.0, 1.0) / 0.22)
    patches = 1.0 + 0.5 * smoothstep(0.0, 1.5, _on_ceiling(rays, clouds))
    return np.asarray((_NIGHT_ZENITH + (_TOWN_GLOW - _NIGHT_ZENITH) * low) * patches)


def _dusk(rays: Array, rise: Array, daylight: Daylight, cover: Array) -> Array:
    """Bright where the sun went down, dark overhead and opposite, with clouds against the light."""
    flat = np.linalg.norm(daylight.toward_sun[:2]) + 1e-9
    toward = (rays[..., :2] @ daylight.toward_sun[:2] / flat)[..., None]
    west = np.exp(2.0 * (toward - 1.0))
    horizon = 190.0 + 180.0 * west
    bare = 125.0 + (horizon - 125.0) * np.exp(-rise / (0.16 + 0.3 * west))
    return np.asarray(bare * (1.0 - 0.45 * cover) * [1.0, 0.97, 1.03])


def _on_ceiling(rays: Array, clouds: Array) -> Array:
    """Read noise off a flat ceiling above; mirrored, so that it has no seam."""
    height = np.maximum(rays[..., 2], 0.05)
    across = 1.0 - np.abs((rays[..., 0] / height * 0.05 + 0.5) % 2.0 - 1.0)
    along = 1.0 - np.abs((rays[..., 1] / height * 0.1 + 0.5) % 2.0 - 1.0)
    columns = (across * (clouds.shape[1] - 1)).astype(np.float32)
    rows = (along * (clouds.shape[0] - 1)).astype(np.float32)
    return np.asarray(cv2.remap(clouds.astype(np.float32), columns, rows, cv2.INTER_LINEAR))
