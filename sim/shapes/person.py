"""A person in parts that move against each other: trunk with head, thighs, shins, feet, upper arms, forearms.

Every limb hangs from its joint at the origin. Measures are those of somebody 1.75 m tall; the trunk's origin
lies between the hips. x is ahead, y left.
"""

from __future__ import annotations

import numpy as np

from sim.paint.people import Look, region
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
    head = merged([_head(), _nose(), *_ears(), *_hair(look, rng)])
    parts = [_torso(broad), head.moved((0.0, 0.0, -0.022))]
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


def _head() -> Mesh:
    sections: list[Section] = [
        (0.54, 0.0, 0.0, 0.05, 0.05),
        (0.60, 0.005, 0.0, 0.051, 0.05),
        (0.622, 0.03, 0.0, 0.062, 0.046),
        (0.645, 0.03, 0.0, 0.078, 0.056),
        (0.68, 0.02, 0.0, 0.093, 0.066),
        (0.72, 0.013, 0.0, 0.1, 0.072),
        (0.76, 0.008, 0.0, 0.101, 0.076),
        (0.80, 0.0, 0.0, 0.1, 0.077),
        (0.835, -0.006, 0.0, 0.088, 0.068),
        (0.858, -0.008, 0.0, 0.06, 0.047),
        (0.868, -0.01, 0.0, 0.004, 0.004),
    ]
    return loft(sections, 18, region("head"), squareness=2.15)


def _nose() -> Mesh:
    x0, y0, x1, y1 = region("head")
    tip = (x0 + 0.42 * (x1 - x0), y0 + 0.70 * (y1 - y0), x0 + 0.44 * (x1 - x0), y0 + 0.74 * (y1 - y0))
    rows: list[Section] = [
        (0.693, 0.112, 0.0, 0.004, 0.006),
        (0.698, 0.116, 0.0, 0.02, 0.017),
        (0.712, 0.112, 0.0, 0.018, 0.013),
        (0.752, 0.102, 0.0, 0.006, 0.008),
    ]
    return loft(rows, 8, tip)


def _ears() -> list[Mesh]:
    x0, y0, x1, y1 = region("head")
    part = (x0, y0 + 0.5 * (y1 - y0), x0 + 0.05 * (x1 - x0), y0 + 0.6 * (y1 - y0))
    rows: list[Section] = [(0.695, 0.0, 0.0, 0.012, 0.006), (0.73, -0.004, 0.0, 0.022, 0.012)]
    ear = loft(rounded(rows, 0.016), 8, part)
    return [ear.moved((0.0, side * 0.076, 0.0)) for side in (-1, 1)]


def _hair(look: Look, rng: np.random.Generator) -> list[Mesh]:
    """A cap of hair that leaves the face free, longer or shorter at the back; a woollen hat over it."""
    parts: list[Mesh] = []
    if look.hair != "bald":
        low = float(rng.uniform(0.46, 0.6)) if look.hair == "long" else 0.685
        sections: list[Section] = [
            (low, -0.062, 0.0, 0.02, 0.05),
            (low + 0.03, -0.058, 0.0, 0.045, 0.066),
            (0.73, -0.036, 0.0, 0.078, 0.081),
            (0.775, -0.018, 0.0, 0.098, 0.086),
            (0.815, -0.006, 0.0, 0.108, 0.086),
            (0.85, -0.008, 0.0, 0.092, 0.073),
            (0.875, -0.012, 0.0, 0.058, 0.046),
            (0.884, -0.012, 0.0, 0.004, 0.004),
        ]
        parts.append(loft(sections, 16, region("hair")))
    if look.hat:
        crown: list[Section] = [
            (0.785, -0.004, 0.0, 0.115, 0.092),
            (0.82, -0.004, 0.0, 0.116, 0.093),
            (0.865, -0.01, 0.0, 0.1, 0.08),
            (0.9, -0.016, 0.0, 0.06, 0.048),
            (0.915, -0.018, 0.0, 0.004, 0.004),
        ]
        parts.append(loft(crown, 16, region("hat")))
    return parts


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
