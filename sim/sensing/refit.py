"""Other lenses on the same rig: every camera gets one model, with about its own field and its own size."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.camera import Camera, CameraModel
from estimator.errors import InputError
from estimator.rig import Rig
from sim.sensing.lens import check_lens

# What a lens of each model is like: its distortion, and the widest half field, left to right, it is made for.
_DISTORTIONS: dict[CameraModel, tuple[float, ...]] = {
    "pinhole": (),
    "brown_conrady": (-0.2, 0.05, 0.0004, -0.0003, 0.002),
    "kannala_brandt": (-0.012, 0.004, -0.002, 0.0003),
}
_WIDEST_DEG: dict[CameraModel, float] = {"pinhole": 60.0, "brown_conrady": 52.0, "kannala_brandt": 100.0}
_LONGEST_SIDE_PX, _MOST_PIXELS = 8192, 20_000_000


def with_lenses(rig: Rig, model: CameraModel) -> Rig:
    """Return a rig whose cameras all have a model; those that have it already keep their lens."""
    cameras = {
        name: replace(mounted, camera=refitted(mounted.camera, model))
        for name, mounted in rig.cameras.items()
    }
    return replace(rig, cameras=cameras)


def check_lenses(rig: Rig) -> None:
    """See that every lens and image can be simulated.

    Raises:
        InputError: A lens folds over inside its image, or an image is too large to be drawn.
    """
    for name, mounted in rig.cameras.items():
        width, height = mounted.camera.size_px
        if max(width, height) > _LONGEST_SIDE_PX or width * height > _MOST_PIXELS:
            raise InputError(
                f"cameras.{name}.size_px: got [{width}, {height}], wanted at most {_LONGEST_SIDE_PX} a side "
                f"and {_MOST_PIXELS / 1e6:g} million pixels: larger images do not fit the renderers"
            )
        try:
            check_lens(mounted.camera)
        except InputError as error:
            raise InputError(f"cameras.{name}: got {error}") from None


def refitted(camera: Camera, model: CameraModel) -> Camera:
    """Return a camera of a model that sees as far to the left and right, if the model can."""
    if camera.model == model:
        return camera
    width, middle_row = camera.size_px[0], camera.center_px[1]
    rays = camera.unproject(np.array([[-0.5, middle_row], [width - 0.5, middle_row]]))
    half_field_rad = float(np.arctan2(np.hypot(rays[:, 0], rays[:, 1]), rays[:, 2]).mean())
    half_field_rad = min(half_field_rad, float(np.radians(_WIDEST_DEG[model])))
    unit = Camera(model, camera.size_px, (1.0, 1.0), (0.0, 0.0), _DISTORTIONS[model])
    reach = unit.project(np.array([[np.sin(half_field_rad), 0.0, np.cos(half_field_rad)]]))[0, 0]
    focal_px = float(round(width / 2 / reach, 1))
    return Camera(model, camera.size_px, (focal_px, focal_px), camera.center_px, _DISTORTIONS[model])
