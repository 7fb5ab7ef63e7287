"""A head with its nose, ears, hair and hat, in the frame of the trunk that carries it."""

from __future__ import annotations

import numpy as np

from sim.paint.looks import Look
from sim.paint.person_layout import region
from sim.shapes.loft import Section, loft, rounded
from sim.shapes.mesh import Mesh, merged


def head_mesh(look: Look, rng: np.random.Generator) -> Mesh:
    """Neck and head, with hair and a hat as worn.

    Args:
        look: What is worn.
        rng: Source of randomness.
    """
    return merged([_head(), _nose(), *_ears(), *_hair(look, rng)])


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
