"""Light: a sun with shadows, the blue and grey light of the sky, and the sky itself."""

from __future__ import annotations

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from estimator.se3 import Array
from sim.light.weather import WeatherConfig
from sim.paint.noise import fractal, smoothstep

_SUN_DISTANCE_M = 150.0
_SKY_SEED = 11


def write_sky(spec: mujoco.MjSpec, weather: WeatherConfig) -> None:
    """Add sun, fill light and skybox."""
    up = _direction(weather.sun_elevation_deg, weather.sun_azimuth_deg)
    spec.visual.headlight.active = 1
    spec.visual.headlight.ambient = [0.41, 0.42, 0.44]
    spec.visual.headlight.diffuse = [0.0, 0.0, 0.0]
    spec.visual.headlight.specular = [0.0, 0.0, 0.0]
    _add_light(spec, "sun", _SUN_DISTANCE_M * up, -up, (1.22, 1.17, 1.07), True)
    _add_light(spec, "sky_above", (0, 0, 50), (0, 0, -1), (0.14, 0.15, 0.17), False)
    away = np.array([-up[0], -up[1], 0.35])
    _add_light(spec, "sky_opposite", (0, 0, 50), -away / np.linalg.norm(away), (0.31, 0.32, 0.34), False)
    faces = _sky_faces()
    texture = spec.add_texture(
        name="sky",
        type=mujoco.mjtTexture.mjTEXTURE_SKYBOX,
        width=faces.shape[1],
        height=faces.shape[0],
        nchannel=3,
    )
    texture.data = faces.tobytes()


def _direction(elevation_deg: float, azimuth_deg: float) -> Array:
    elevation, azimuth = np.deg2rad([elevation_deg, azimuth_deg])
    return np.array(
        [np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)]
    )


def _add_light(
    spec: mujoco.MjSpec, name: str, pos: ArrayLike, toward: ArrayLike, diffuse: ArrayLike, shadow: bool
) -> None:
    spec.worldbody.add_light(
        name=name,
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL,
        pos=pos,
        dir=toward,
        diffuse=diffuse,
        ambient=[0.0, 0.0, 0.0],
        specular=[0.3, 0.3, 0.3] if shadow else [0.0, 0.0, 0.0],
        castshadow=shadow,
    )


def _sky_faces(size: int = 512) -> Array:
    """Return faces right, left, up, down, front, back, one above the other; (6 size, size, 3) uint8."""
    rng = np.random.default_rng(_SKY_SEED)
    noise = fractal(rng, (size, 2 * size), (size / 5, size / 3), 7, 0.55)
    u, v = np.meshgrid((np.arange(size) + 0.5) / size * 2 - 1, (np.arange(size) + 0.5) / size * 2 - 1)
    one = np.ones_like(u)
    # Cube-map directions in GL's own frame, in which the sky's up is +y.
    rays = [(one, -v, -u), (-one, -v, u), (u, one, v), (u, -one, -v), (u, -v, one), (-u, -v, -one)]
    faces = []
    for x, y, z in rays:
        norm = np.sqrt(x * x + y * y + z * z)
        faces.append(_sky_color(np.stack([x, y, z], axis=-1) / norm[..., None], noise))
    return np.vstack(faces)


def _sky_color(ray: Array, noise: Array) -> Array:
    """Haze at the horizon, blue above, clouds on a flat ceiling."""
    rise = np.clip(ray[..., 1], 0.0, 1.0)[..., None]
    haze, zenith = np.array([238.0, 239.0, 240.0]), np.array([128.0, 164.0, 210.0])
    color = haze + (zenith - haze) * rise**0.55
    height = np.maximum(ray[..., 1], 0.05)
    px = ((ray[..., 0] / height * 0.05 + 0.5) % 1.0) * (noise.shape[1] - 1)
    py = ((ray[..., 2] / height * 0.1 + 0.5) % 1.0) * (noise.shape[0] - 1)
    cloud = smoothstep(0.0, 1.2, noise[py.astype(int), px.astype(int)]) * smoothstep(0.04, 0.2, ray[..., 1])
    color += (np.array([246.0, 246.0, 246.0]) - color) * 0.85 * cloud[..., None]
    result: Array = np.clip(color, 0, 255).astype(np.uint8)
    return result
