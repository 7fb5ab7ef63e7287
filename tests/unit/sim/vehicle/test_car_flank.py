"""The sides of the car: alike on both, close to the body, and no more than a car's width."""

import mujoco
import numpy as np

from sim.vehicle.car import CarConfig, write_car
from sim.vehicle.car_flank import DOORS_M, flank_details, half_width_m


def test_every_detail_stands_off_the_side_it_is_on() -> None:
    for detail in flank_details():
        _, y, z = detail.points_m.T
        above = z > DOORS_M[-1][0]
        body = np.where(above, 0.62, half_width_m(DOORS_M, z))
        assert (y - body).max() > 0.001, detail.name
        assert (y < half_width_m(DOORS_M, np.minimum(z, DOORS_M[-1][0])) + 0.03).all(), detail.name


def test_the_right_side_mirrors_the_left() -> None:
    spec = mujoco.MjSpec()
    write_car(spec, CarConfig())
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    for detail in flank_details():
        left, right = (_corners(model, data, f"car_{side}_{detail.name}") for side in ("left", "right"))
        np.testing.assert_allclose(
            np.sort(left[:, [0, 2]], 0), np.sort(right[:, [0, 2]], 0), atol=1e-6, err_msg=detail.name
        )
        np.testing.assert_allclose(np.sort(left[:, 1]), np.sort(-right[:, 1]), atol=1e-6)


def _corners(model: mujoco.MjModel, data: mujoco.MjData, mesh: str) -> np.ndarray:
    """(N, 3) world vertices of the geom that shows a mesh."""
    number = model.mesh(mesh).id
    geom = int(
        np.flatnonzero((model.geom_type == mujoco.mjtGeom.mjGEOM_MESH) & (model.geom_dataid == number))[0]
    )
    first, count = model.mesh_vertadr[number], model.mesh_vertnum[number]
    points = model.mesh_vert[first : first + count]
    return data.geom_xpos[geom] + points @ data.geom_xmat[geom].reshape(3, 3).T
