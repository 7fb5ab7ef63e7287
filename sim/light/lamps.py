"""Light of lamps that stand in the street or in a tunnel: inverse square, cosine, and the lamp's own cone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sim.light.surfaces import Floats

REACH_M = 20.0  # beyond, a lamp's light is faded to nothing
_SOFTEST_M2 = 1.5  # keeps what touches a lamp finite


@dataclass(frozen=True, eq=False)
class LightSource:
    """A small lamp.

    Attributes:
        position_m: World position.
        aim: Unit world direction of the middle of its light.
        intensity: Illuminance at one metre; 1 makes white look as it does in flat full daylight.
        cone: Cosines of the angles off the aim where its light ends, and where it is full.
        radius_m: Of the lamp as it is seen.
        level: Of its face, in levels of a sunny day, to who looks straight at it.
        aside: Share of that level that shows at right angles to its aim.
    """

    position_m: tuple[float, float, float]
    aim: tuple[float, float, float]
    intensity: float
    cone: tuple[float, float] = (0.05, 0.45)
    radius_m: float = 0.16
    level: float = 255.0
    aside: float = 0.25


def lamp_light(sources: Sequence[LightSource], points_m: Floats, normals: Floats) -> Floats:
    """Return the illuminance by lamps.

    Args:
        sources: The lamps.
        points_m: (3, ...) world positions.
        normals: (3, ...) unit world normals.

    Returns:
        (...), in the unit of ``LightSource.intensity``.
    """
    shape = points_m.shape[1:]
    points, normals = points_m.reshape(3, -1), normals.reshape(3, -1)
    total = np.zeros(points.shape[1], np.float32)
    for source in sources:
        lit, share = _one(source, points, normals)
        total[lit] += share
    return total.reshape(shape)


def _one(source: LightSource, points: Floats, normals: Floats) -> tuple[npt.NDArray[np.intp], Floats]:
    """Return the indices of the points that a lamp reaches, and the illuminance there."""
    at = np.asarray(source.position_m, np.float32)
    lit = np.flatnonzero((np.abs(points[0] - at[0]) < REACH_M) & (np.abs(points[1] - at[1]) < REACH_M))
    x, y, z = (at[k] - points[k, lit] for k in range(3))
    distance2 = x * x + y * y + z * z
    facing = x * normals[0, lit] + y * normals[1, lit] + z * normals[2, lit]
    distance = np.sqrt(distance2)
    aim = np.asarray(source.aim, np.float32)
    off_aim = -(aim[0] * x + aim[1] * y + aim[2] * z) / (distance + np.float32(1e-6))
    window = np.square(np.maximum(1 - distance2 / np.float32(REACH_M**2), 0))
    strength = np.float32(source.intensity) * _in_cone(source, off_aim) * window
    reaching = strength * np.maximum(facing, 0)
    return lit, reaching / ((distance2 + np.float32(_SOFTEST_M2)) * (distance + np.float32(1e-6)))


def _in_cone(source: LightSource, off_aim: Floats) -> Floats:
    end, full = source.cone
    t = np.clip((off_aim - np.float32(end)) / np.float32(full - end), 0, 1)
    return np.asarray(t * t * (3 - 2 * t))
