"""The model's lights for renderers that reckon with linear light.

The classic renderer adds lights up in display values. Colours are therefore taken to the power of the
display's gamma, and scaled so that a sunlit street is about as bright in all renderers.
"""

from __future__ import annotations

import mujoco
import numpy as np

from estimator.se3 import Array

GAMMA = 2.2
DAYLIGHT = 1.2  # of the classic renderer's light, in linear terms: sunlit whites just clip
LAMP_AT_M = 5.0  # lamps that do not fade with the square are as bright as in the classic renderer here
DIRECTIONAL = mujoco.mjtLightType.mjLIGHT_DIRECTIONAL.value
SPOT = mujoco.mjtLightType.mjLIGHT_SPOT.value


def linear(display: Array) -> Array:
    """Return the linear light of display values."""
    return np.asarray(np.maximum(display, 0.0) ** GAMMA)


def shines(model: mujoco.MjModel, index: int) -> bool:
    """Tell lamps and the sun from directional fill light, which counts as part of the sky."""
    return bool(model.light_type[index] != DIRECTIONAL or model.light_castshadow[index])


def lamp_light(model: mujoco.MjModel, index: int) -> Array:
    """Return (3,) linear light on a white wall that faces a lamp, at 1 m for all but directional ones."""
    color = DAYLIGHT * linear(model.light_diffuse[index]) * float(model.light_active[index])
    if model.light_type[index] == DIRECTIONAL:
        return np.asarray(color)
    constant, by_m, by_m2 = model.light_attenuation[index]
    return np.asarray(color * LAMP_AT_M**2 / (constant + by_m * LAMP_AT_M + by_m2 * LAMP_AT_M**2))


def sky_light(model: mujoco.MjModel) -> Array:
    """Return (3,) linear light, 1 at most, on a white wall from all around: ambient and all fill light."""
    headlight = model.vis.headlight
    color = np.asarray(headlight.ambient, float) * float(headlight.active > 0)
    for index in range(model.nlight):
        active = float(model.light_active[index])
        color = color + active * model.light_ambient[index]
        if not shines(model, index):
            color = color + active * model.light_diffuse[index] / 4  # a cosine's mean over all directions
    return np.minimum(DAYLIGHT * linear(color), 1.0)
