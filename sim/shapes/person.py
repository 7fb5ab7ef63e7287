"""A person in parts that move against each other: trunk with head, thighs, shins, feet, upper arms, forearms.

Every limb hangs from its joint at the origin. Measures are those of somebody 1.75 m tall; the trunk's origin
lies between the hips. x is ahead, y left.
"""

from __future__ import annotations

import numpy as np

from sim.paint.looks import Look
from sim.paint.person_layout import region
from sim.shapes.head import head_mesh
from sim.shapes.loft import Section, limb, loft, rounded
from sim.shapes.mesh import Mesh, merged

THIGH_M, SHIN_M, ANKLE_M = 0.44, 0.41, 0.075
UPPER_ARM_M, FOREARM_M = 0.29, 0.25
HIP_M = (0.0, 0.085, 0.0)  # of the left side, from the trunk's origin
SHOULDER_M = (-0.012, 0.182, 0.455)
TALL_M = 1.75


def trunk_mesh(look: Look, broad: float, rng: np.random.Generator) -> Mesh:
    """Torso, neck and head, with whatever is worn on them.

    Args:
        look: What is worn.
        broad: Girth, 1 is the average.
        rng: Source of randomness.
    """
    parts = [_torso(broad), head_mesh(look, rng).moved((0.0, 0.0, -0.022))]
    if look.coat:
        parts.append(_coat(broad))
    if look.bag:
        parts.append(_backpack(broad))
    return merged(parts)


def _torso(broad: float) -> Mesh:
    b = broad
    sections: list[Section] = [
        (-0.11, 0.0, 0.0, 0.03, 0.06),
        (-0.09, 0.0, 0.0, 0.085 * b, 0.13 * b),
        (-0.03, -0.005, 0.0, 0.118 * b, 0.168 * b),
        (0.05, -0.005, 0.0, 0.122 * b, 0.17 * b),
        (0.14, 0.005, 0.0, 0.115 * b, 0.155 * b),
        (0.22, 0.01, 0.0, 0.112 * b, 0.15 * b),
        (0.32, 0.012, 0.0, 0.122 * b, 0.164 * b),
        (0.41, 0.005, 0.0, 0.12 * b, 0.172 * b),
        (0.465, -0.008, 0.0, 0.1 * b, 0.172 * b),
        (0.50, -0.012, 0.0, 0.08, 0.138),
        (0.525, -0.01, 0.0, 0.064, 0.085),
        (0.555, -0.006, 0.0, 0.058, 0.066),
        (0.575, -0.004, 0.0, 0.05, 0.05),
        (0.577, -0.004, 0.0, 0.004, 0.004),
    ]
    return loft(sections, 20, region("torso"), squareness=2.3)


def _coat(broad: float) -> Mesh:
    b = broad
    sections: list[Section] = [
        (-0.23, 0.0, 0.0, 0.2 * b, 0.212 * b),
        (-0.12, 0.0, 0.0, 0.176 * b, 0.195 * b),
        (0.0, 0.0, 0.0, 0.14 * b, 0.18 * b),
        (0.16, 0.005, 0.0, 0.122 * b, 0.162 * b),
        (0.25, 0.01, 0.0, 0.11 * b, 0.145 * b),
    ]
    return loft(sections, 20, region("coat"), squareness=2.3)


def _backpack(broad: float) -> Mesh:
    rows: list[Section] = [
        (0.06, -0.2, 0.0, 0.085, 0.14),
        (0.25, -0.2, 0.0, 0.09, 0.145),
        (0.4, -0.185, 0.0, 0.07, 0.12),
    ]
    rows = [(z, x * broad, y, a, c) for z, x, y, a, c in rows]
    return loft(rounded(rows, 0.05), 16, region("bag"), squareness=3.2)


def thigh_mesh(broad: float) -> Mesh:
    """From hip to knee."""
    radii = [r * broad for r in (0.088, 0.094, 0.086, 0.074, 0.066)]
    return limb(THIGH_M, radii, region("thigh"), 12, flat=0.93)


def shin_mesh(broad: float) -> Mesh:
    """From knee to ankle, in a trouser leg."""
    radii = [r * broad for r in (0.066, 0.066, 0.06, 0.056, 0.056)]
    return limb(SHIN_M, radii, region("shin"), 12)


def foot_mesh() -> Mesh:
    """A shoe on the ground, its ankle at the origin."""
    z = -ANKLE_M
    sections: list[Section] = [
        (-0.085, 0.0, z + 0.03, 0.012, 0.012),
        (-0.075, 0.0, z + 0.042, 0.032, 0.04),
        (-0.04, 0.0, z + 0.052, 0.037, 0.052),
        (0.02, 0.0, z + 0.048, 0.038, 0.048),
        (0.08, 0.0, z + 0.034, 0.044, 0.034),
        (0.14, 0.0, z + 0.026, 0.045, 0.026),
        (0.175, 0.0, z + 0.02, 0.03, 0.018),
        (0.185, 0.0, z + 0.016, 0.006, 0.006),
    ]
    return loft(sections, 12, region("shoe"), axis="x", squareness=2.6)


def upper_arm_mesh(broad: float) -> Mesh:
    """From shoulder to elbow."""
    return limb(UPPER_ARM_M, [r * broad for r in (0.05, 0.052, 0.046, 0.041)], region("sleeve"))


def forearm_mesh(broad: float) -> Mesh:
    """From elbow to wrist, and the hand."""
    sleeve = limb(FOREARM_M, [r * broad for r in (0.043, 0.043, 0.037, 0.032)], region("cuff"))
    rows: list[Section] = [
        (-0.17, 0.012, 0.0, 0.022, 0.012),
        (-0.12, 0.01, 0.0, 0.036, 0.017),
        (-0.06, 0.006, 0.0, 0.042, 0.02),
        (0.0, 0.0, 0.0, 0.026, 0.022),
    ]
    hand = loft(rounded(rows, 0.012), 8, region("hand")).moved((0.0, 0.0, -FOREARM_M))
    return merged([sleeve, hand])
