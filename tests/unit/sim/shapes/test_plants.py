"""Plants: leaves that look out of their crown, trunks clear of the street, several species that differ."""

import numpy as np
import pytest

from sim.shapes.bushes import bush_mesh, hedge_mesh
from sim.shapes.mesh import Mesh
from sim.shapes.trees import SPECIES, SPRUCE, Species, tree_mesh


def outward_share(mesh: Mesh, center: np.ndarray) -> float:
    a, b, c = (mesh.vertices_m[mesh.faces[:, k]] for k in range(3))
    return float(np.mean(np.sum(np.cross(b - a, c - a) * (a - center), axis=1) > 0))


def test_leaves_of_a_bush_look_out_of_it() -> None:
    mesh = bush_mesh(0.8, "lime", np.random.default_rng(0))
    assert outward_share(mesh, np.array([0.0, 0.0, 0.3])) > 0.7


@pytest.mark.parametrize("species", (*SPECIES, SPRUCE), ids=lambda species: species.leaf)
def test_a_tree_stands_on_the_ground_and_is_as_tall_as_its_species(species: Species) -> None:
    mesh = tree_mesh(species, True, np.random.default_rng(1))
    low, high = mesh.vertices_m[:, 2].min(), mesh.vertices_m[:, 2].max()
    assert -0.2 < low < 0.05
    assert species.height_m[0] - 0.8 < high < species.height_m[1] + 0.8


@pytest.mark.parametrize("species", SPECIES, ids=lambda species: species.leaf)
def test_a_street_tree_leaves_room_for_a_car_below_its_crown(species: Species) -> None:
    vertices = tree_mesh(species, True, np.random.default_rng(2)).vertices_m
    low = vertices[vertices[:, 2] < 1.5]
    assert np.abs(low[:, :2]).max() < 0.5


def test_a_crown_has_depth_for_parallax() -> None:
    mesh = tree_mesh(SPECIES[0], True, np.random.default_rng(3))
    crown = mesh.vertices_m[mesh.vertices_m[:, 2] > 3.5]
    facing = crown[crown[:, 0] < 0.0]  # what a camera far on -x sees of it
    assert np.ptp(np.quantile(facing[:, 0], [0.1, 0.9])) > 1.0


def test_a_coarse_tree_has_far_fewer_triangles() -> None:
    fine, coarse = (tree_mesh(SPECIES[0], detail, np.random.default_rng(4)) for detail in (True, False))
    assert len(coarse.faces) < 0.6 * len(fine.faces)


def test_a_hedge_keeps_to_its_place() -> None:
    mesh = hedge_mesh(4.0, 1.1, 0.5, "hornbeam", np.random.default_rng(5))
    assert np.abs(mesh.vertices_m[:, 0]).max() < 0.5
    assert np.abs(mesh.vertices_m[:, 1]).max() < 2.2
