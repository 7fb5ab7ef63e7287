"""How much of what one camera sees another one sees at the same instant."""

from __future__ import annotations

import numpy as np

from sim.channels.labels import CLASSES, Labels
from sim.channels.survey import Sight, Survey

_STRIDE_PX = 4  # of the grid of pixels that are asked


def visibility(survey: Survey, labels: Labels) -> dict[str, dict[str, float]]:
    """Return for each camera the share of its pixels that show what each other camera sees too.

    Pixels are asked on a grid. Those of the sky and of the own car count as seen by nobody else: they show no
    place in the world.
    """
    chosen = {name: _places(sight, labels) for name, sight in survey.sights.items()}
    return {
        name: {
            other: _share(sight, survey.sights[other], *chosen[name])
            for other in survey.sights
            if other != name
        }
        for name, sight in survey.sights.items()
    }


def _places(sight: Sight, labels: Labels) -> tuple[np.ndarray, int]:
    """Return the asked pixels that show a place in the world, and how many were asked."""
    width, height = sight.camera.size_px
    rows, columns = np.mgrid[_STRIDE_PX // 2 : height : _STRIDE_PX, _STRIDE_PX // 2 : width : _STRIDE_PX]
    asked = (rows * width + columns).ravel()
    kinds = labels.classes(sight.geom[asked])
    nowhere = np.isin(kinds, [CLASSES.index("sky"), CLASSES.index("own_car")])
    return asked[~nowhere], len(asked)


def _share(sight: Sight, other: Sight, chosen: np.ndarray, asked: int) -> float:
    other_from_cam = other.world_from_cam.inverse() @ sight.world_from_cam
    _, seen = other.sees(other_from_cam.apply(sight.points_cam(chosen)), sight.geom[chosen])
    return float(seen.sum() / asked)
