"""Where each part of a coat of street furniture lies in its texture."""

from __future__ import annotations

from sim.shapes.mesh import Rect, texture_part

SIZE_M = (5.0, 3.7)
SIGN_M = 0.6
PLATE_M = (0.95, 0.32)
_INSET_M = 0.01
REGIONS_M = {  # left, top, width, height
    "steel": (0.0, 0.0, 1.0, 1.0),
    "green": (1.0, 0.0, 1.0, 1.0),
    "stripes": (3.3, 0.0, 0.3, 1.2),
    "lamp": (3.65, 0.0, 0.3, 0.5),
    "back": (3.65, 0.55, 0.3, 0.6),
    "post_box": (4.0, 0.0, 0.48, 1.2),
    "meter": (4.5, 0.0, 0.48, 1.2),
    **{f"plate_{k}": (2.1, 0.33 * k, *PLATE_M) for k in range(4)},
    **{
        name: (0.65 * k, 1.36, SIGN_M, SIGN_M)
        for k, name in enumerate(
            ("limit", "no_parking", "crossing", "warning", "give_way", "priority", "stop")
        )
    },
    "wood": (0.0, 2.0, 1.6, 0.65),
    "concrete": (1.7, 2.0, 1.1, 0.65),
    "bin": (2.9, 2.0, 0.7, 0.65),
    "no_entry": (3.65, 2.02, SIGN_M, SIGN_M),
    "chevron": (4.3, 2.02, SIGN_M, SIGN_M),
    "signal_red": (0.0, 2.7, 0.32, 0.96),
    "signal_green": (0.36, 2.7, 0.32, 0.96),
    "signal_walk": (0.72, 2.7, 0.32, 0.64),
    "glass": (1.1, 2.7, 1.2, 0.96),
    "ticket": (2.35, 2.7, 0.6, 0.96),
    "trolley": (3.0, 2.7, 0.9, 0.96),
    "menu": (3.95, 2.7, 0.6, 0.96),
}


def region(name: str) -> Rect:
    """Texture coordinates of a part, a little inside its edge."""
    return texture_part(REGIONS_M[name], SIZE_M, _INSET_M)
