from __future__ import annotations

import numpy as np
import pytest

from estimator.camera import Camera
from estimator.errors import InputError
from estimator.rig import MountedCamera, Rig
from estimator.se3 import SE3
from sim.vehicle.mounting_place import check_places

LENS = Camera("pinhole", (640, 400), (457.0, 457.0), (319.5, 199.5), ())


def rig_at(x_m: float, y_m: float, z_m: float) -> Rig:
    place = MountedCamera(LENS, SE3(np.eye(3), np.array([x_m, y_m, z_m])))
    return Rig(
        "front", {"front": MountedCamera(LENS, SE3(np.eye(3), np.array([1.8, 0, 1.4]))), "rear": place}
    )


@pytest.mark.parametrize("place_m", [(-0.9, 0.0, 1.2), (-9.0, 1.2, 4.0), (3.0, -1.0, 0.1)])
def test_a_camera_on_a_car_or_a_lorry_is_taken(place_m: tuple[float, float, float]) -> None:
    check_places(rig_at(*place_m))


@pytest.mark.parametrize(
    "place_m", [(1.8, 0.1, -5.0), (0.0, 0.0, 0.0), (11.0, 0.0, 1.2), (0.0, -11.0, 1.2), (0.0, 0.0, 6.0)]
)
def test_a_camera_off_the_car_is_refused_by_name(place_m: tuple[float, float, float]) -> None:
    with pytest.raises(
        InputError, match=r"cameras\.rear\.ego_from_cam\.translation_m: got .* wanted a camera on the car"
    ):
        check_places(rig_at(*place_m))
