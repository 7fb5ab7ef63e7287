"""Where on a car a camera can sit."""

from __future__ import annotations

from estimator.errors import InputError
from estimator.rig import Rig

_LOWEST_M, _HIGHEST_M = 0.1, 5.0
_FARTHEST_M = 10.0


def check_places(rig: Rig) -> None:
    """See that every camera sits on the car, above the road.

    Raises:
        InputError: One does not.
    """
    for name, mounted in rig.cameras.items():
        x_m, y_m, z_m = mounted.ego_from_cam.translation
        if not (_LOWEST_M <= z_m <= _HIGHEST_M and abs(x_m) <= _FARTHEST_M and abs(y_m) <= _FARTHEST_M):
            raise InputError(
                f"cameras.{name}.ego_from_cam.translation_m: got [{x_m:g}, {y_m:g}, {z_m:g}], wanted a "
                f"camera on the car: {_LOWEST_M:g} to {_HIGHEST_M:g} m above the road, within "
                f"{_FARTHEST_M:g} m of the rear axle along x and y"
            )
