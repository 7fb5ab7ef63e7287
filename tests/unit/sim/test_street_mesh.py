"""Meshes and footprints: outward faces, upright textures, honest gaps."""

import numpy as np
import pytest

from sim.shapes.mesh import Mesh, box, disc, merged, tube
from sim.shapes.parked_cars import KINDS, CarKind, car_mesh, car_skin, outline_m, varied
from sim.streets.footprint import Ground, gap_m, rectangle_m


def outward_share(mesh: Mesh, center: np.ndarray) -> float:
    """Share of triangles whose winding looks away from a point inside."""
    a, b, c = (mesh.vertices_m[mesh.faces[:, k]] for k in range(3))
    return float(np.mean(np.sum(np.cross(b - a, c - a) * (a - center), axis=1) > 0))


def test_a_box_looks_outwards() -> None:
    assert outward_share(box((0, 0, 0), (1, 2, 3)), np.array([0.5, 1.0, 1.5])) == 1.0


def test_a_tube_looks_outwards_and_its_normals_agree() -> None:
    z = np.linspace(0, 2, 4)
    mesh = tube(np.column_stack([0 * z, 0 * z, z]), np.full(4, 0.3), 8)
    assert outward_share(mesh, np.array([0.0, 0.0, 1.0])) == 1.0
    assert (np.sum(mesh.normals[:, :2] * mesh.vertices_m[:, :2], axis=1) > 0).all()


def test_a_disc_faces_ahead_and_reads_upright() -> None:
    mesh = disc((0, 0, 1), 0.5, 12)
    assert outward_share(mesh, np.array([-1.0, 0, 1])) == 1.0
    top = mesh.uvs[np.argmax(mesh.vertices_m[:, 2])]
    assert top[1] == pytest.approx(0.0)


def test_a_wall_of_a_box_reads_from_left_to_right() -> None:
    mesh = box((0, 0, 0), (1, 1, 1))
    front = np.isclose(mesh.normals[:, 1], -1.0)  # seen from -y, +x is to the right
    x, u = mesh.vertices_m[front, 0], mesh.uvs[front, 0]
    np.testing.assert_allclose(u, x)


@pytest.mark.parametrize("kind", sorted(set(KINDS), key=repr))
def test_a_parked_car_looks_outwards_on_its_wheels(kind: CarKind) -> None:
    mesh = car_mesh(kind)
    assert outward_share(mesh, np.array([0.0, 0.0, 0.5])) > 0.75  # the inner walls of tyres look inwards
    lowest, highest = mesh.vertices_m.min(axis=0), mesh.vertices_m.max(axis=0)
    length, width = outline_m(kind)
    np.testing.assert_allclose(highest[:2] - lowest[:2], [length, width], atol=0.05)
    assert lowest[2] == pytest.approx(0.0)


def test_makes_of_a_kind_differ_but_fit_their_bay() -> None:
    made = [varied(kind, np.random.default_rng(k)) for k, kind in enumerate(KINDS * 4)]
    assert len({make.profile_m for make in made}) == len(made)
    assert max(outline_m(make)[0] for make in made) < 4.8
    images = {car_skin(make, np.random.default_rng(k)).image.tobytes() for k, make in enumerate(made)}
    assert len(images) == len(made)


def test_merging_keeps_every_triangle_where_it_was() -> None:
    one, other = box((0, 0, 0), (1, 1, 1)), box((5, 0, 0), (6, 1, 1))
    both = merged([one, other])
    np.testing.assert_array_equal(
        both.vertices_m[both.faces[len(one.faces) :]], other.vertices_m[other.faces]
    )


def test_turning_about_z_turns_normals_too() -> None:
    mesh = disc((1, 0, 0), 0.5, 8).moved((0, 0, 2), np.pi / 2)
    np.testing.assert_allclose(mesh.normals, np.tile([0.0, 1.0, 0.0], (8, 1)), atol=1e-12)
    np.testing.assert_allclose(mesh.vertices_m.mean(axis=0), [0, 1, 2], atol=1e-12)


def test_gap_is_the_distance_of_parallel_walls_and_negative_on_overlap() -> None:
    one = rectangle_m(np.zeros(2), 0.0, 2.0, 1.0)
    assert gap_m(one, rectangle_m(np.array([3.0, 0.0]), 0.0, 2.0, 1.0)) == pytest.approx(1.0)
    assert gap_m(one, rectangle_m(np.array([0.5, 0.2]), 0.7, 1.0, 1.0)) < 0


def test_ground_is_given_away_once() -> None:
    ground = Ground([rectangle_m(np.zeros(2), 0.0, 1.0, 1.0)])
    spot = rectangle_m(np.array([2.0, 0.0]), 0.3, 1.0, 1.0)
    assert not ground.claim(rectangle_m(np.array([0.8, 0.0]), 0.0, 1.0, 1.0), 0.0)
    assert ground.claim(spot, 0.0)
    assert not ground.claim(spot, 0.0)
