"""Shapes of what moves: bodies that look outwards, as large as people and vehicles are."""

from __future__ import annotations

import numpy as np
import pytest

from sim.paint.looks import draw_look
from sim.paint.people import paint_person
from sim.shapes.bicycle import WHEEL_M, WHEELBASE_M, frame_mesh
from sim.shapes.bicycle import wheel_mesh as bicycle_wheel_mesh
from sim.shapes.heavy import BUS, TRUCK, HeavyKind, heavy_body
from sim.shapes.loft import hanging_along, limb, loft, rounded
from sim.shapes.mesh import Mesh
from sim.shapes.person import TALL_M, foot_mesh, trunk_mesh
from sim.shapes.wheel import wheel_mesh

WHOLE = (0.0, 0.0, 1.0, 1.0)


def volume_m3(mesh: Mesh) -> float:
    """Positive for a closed body whose faces look outwards."""
    a, b, c = (mesh.vertices_m[mesh.faces[:, k]] for k in range(3))
    return float(np.sum(np.cross(a, b) * c) / 6)


def test_normals_of_a_loft_point_outwards() -> None:
    mesh = loft([(z, 0.0, 0.0, 0.3, 0.2) for z in (0.0, 0.5, 1.0)], 24)
    assert (np.sum(mesh.normals[:, :2] * mesh.vertices_m[:, :2], axis=1) > 0).all()


@pytest.mark.parametrize("axis", ["x", "z"])
def test_a_loft_looks_outwards_along_either_axis(axis: str) -> None:
    rows = rounded([(0.0, 0.0, 0.0, 0.1, 0.1), (1.0, 0.0, 0.0, 0.1, 0.1)], 0.05)
    assert volume_m3(loft(rows, 24, axis="x" if axis == "x" else "z")) == pytest.approx(np.pi * 0.01, rel=0.1)


def test_a_limb_hangs_from_its_joint() -> None:
    mesh = limb(0.4, (0.08, 0.06), WHOLE)
    low, high = mesh.vertices_m[:, 2].min(), mesh.vertices_m[:, 2].max()
    assert low == pytest.approx(-0.46) and 0 < high < 0.08


@pytest.mark.parametrize("seed", range(4))
def test_a_person_is_as_tall_as_people_are(seed: int) -> None:
    rng = np.random.default_rng(seed)
    trunk = trunk_mesh(draw_look(rng), 1.0, rng)
    hip_m = 0.925
    assert TALL_M - 0.06 < hip_m + trunk.vertices_m[:, 2].max() < TALL_M + 0.1
    assert 0.3 < np.ptp(trunk.vertices_m[:, 1]) < 0.5
    assert volume_m3(trunk) > 0.03


def test_people_wear_different_things() -> None:
    skins = []
    for seed in range(6):
        rng = np.random.default_rng(seed)
        skins.append(paint_person(draw_look(rng), rng))
    means = np.array([skin.mean(axis=(0, 1)) for skin in skins])
    assert min(np.linalg.norm(a - b) for k, a in enumerate(means) for b in means[:k]) > 3.0


def test_a_sole_is_flat_on_the_ground() -> None:
    foot = foot_mesh()
    z = foot.vertices_m[:, 2]
    assert -0.085 < z.min() < -0.07
    assert np.ptp(foot.vertices_m[z < z.min() + 0.012][:, 0]) > 0.15


def test_a_bicycle_stands_on_its_wheels() -> None:
    assert np.abs(bicycle_wheel_mesh().vertices_m[:, [0, 2]]).max() == pytest.approx(WHEEL_M, abs=0.003)
    frame = frame_mesh().vertices_m
    assert frame[:, 2].min() > 0.2
    assert frame[:, 0].max() < WHEELBASE_M + WHEEL_M + 0.1


@pytest.mark.parametrize("kind", [TRUCK, BUS])
def test_a_large_vehicle_looks_outwards_and_has_its_size(kind: HeavyKind) -> None:
    mesh, skin = heavy_body(kind, np.random.default_rng(0))
    size = np.ptp(mesh.vertices_m, axis=0)
    np.testing.assert_allclose(
        [size[0], mesh.vertices_m[:, 2].max()], [kind.length_m, kind.height_m], atol=0.01
    )
    assert volume_m3(mesh) > 0.6 * kind.length_m * kind.width_m * 2.0
    assert skin.image.std() > 20


def test_a_wheel_turns_about_y() -> None:
    mesh = wheel_mesh(0.33, 0.2, WHOLE, WHOLE)
    np.testing.assert_allclose(np.ptp(mesh.vertices_m, axis=0), [0.66, 0.2, 0.66], atol=0.01)


def test_what_hangs_can_point_anywhere() -> None:
    toward = np.array([0.3, -0.5, -0.6])
    turn = hanging_along(toward)
    np.testing.assert_allclose(turn @ [0, 0, -1], toward / np.linalg.norm(toward))
    np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-12)
    assert np.linalg.det(turn) == pytest.approx(1.0)
