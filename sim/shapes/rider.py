"""Somebody on a bicycle: the parts of a person, leaned forward, hands on the bar."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.looks import Look
from sim.shapes.bicycle import GRIP_M, SADDLE_M
from sim.shapes.loft import hanging_along, pitch_rotation, turned
from sim.shapes.mesh import Mesh, merged
from sim.shapes.person import (
    FOREARM_M,
    SHOULDER_M,
    UPPER_ARM_M,
    forearm_mesh,
    trunk_mesh,
    upper_arm_mesh,
)

HIP_M = (SADDLE_M[0] - 0.03, 0.085, SADDLE_M[2] + 0.07)  # of the left leg
_LEAN_RAD = 0.62
_NECK_M = 0.52  # above the hips; from here on the head is held up
_WRIST_M = 0.06  # of the hand above the grip


def rider_mesh(look: Look, broad: float, rng: np.random.Generator) -> Mesh:
    """Trunk, head and arms of a rider in the frame of the bicycle."""
    hips = np.array([HIP_M[0], 0.0, HIP_M[2]])
    lean = pitch_rotation(_LEAN_RAD)
    trunk = turned(_head_held_up(trunk_mesh(look, broad, rng)), lean, hips)
    arms = [mesh for side in (1.0, -1.0) for mesh in _arm(side, lean, hips, broad)]
    return merged([trunk, *arms])


def _head_held_up(trunk: Mesh) -> Mesh:
    """Bend the neck back by most of the lean, little by little over its height."""
    share = np.clip((trunk.vertices_m[:, 2] - _NECK_M) / 0.1, 0.0, 1.0)[:, None]
    neck = np.array([0.0, 0.0, _NECK_M + 0.03])
    back = pitch_rotation(-0.75 * _LEAN_RAD)
    bent = (trunk.vertices_m - neck) @ back.T + neck
    normals = trunk.normals + share * (trunk.normals @ back.T - trunk.normals)
    # Long hair and bags below the neck stay with the back.
    vertices = trunk.vertices_m + share * (bent - trunk.vertices_m)
    return Mesh(vertices, normals / np.linalg.norm(normals, axis=1, keepdims=True), trunk.uvs, trunk.faces)


def _arm(side: float, lean: Array, hips: Array, broad: float) -> list[Mesh]:
    shoulder = lean @ (np.array(SHOULDER_M) * [1, side, 1]) + hips
    wrist = np.array([GRIP_M[0] - 0.1, side * GRIP_M[1], GRIP_M[2] + _WRIST_M])
    elbow = _elbow(shoulder, wrist, np.array([-0.35, 0.45 * side, -1.0]))
    upper = turned(upper_arm_mesh(broad), hanging_along(elbow - shoulder), shoulder)
    fore = turned(forearm_mesh(broad), hanging_along(wrist - elbow), elbow)
    return [upper, fore]


def _elbow(shoulder: Array, wrist: Array, toward: Array) -> Array:
    """Where two links meet, bent towards a direction; straight if the way is too long for them."""
    way = wrist - shoulder
    reach = min(float(np.linalg.norm(way)), 0.999 * (UPPER_ARM_M + FOREARM_M))
    along = way / np.linalg.norm(way)
    first = (UPPER_ARM_M**2 - FOREARM_M**2 + reach**2) / (2 * reach)
    bend = toward - (toward @ along) * along
    bend /= np.linalg.norm(bend)
    result: Array = shoulder + first * along + np.sqrt(max(UPPER_ARM_M**2 - first**2, 0.0)) * bend
    return result
