"""Houses: closed towards every side, roofs over their walls, shapes that follow a line."""

import itertools

import numpy as np
import pytest

from sim.paint.facade import paint_facade
from sim.shapes.facade import FLANK_M, Facade
from sim.shapes.facade_plan import CANYON, OLD_TOWN, draw_facade, draw_plain_house
from sim.shapes.gateway import GATE_FLOORS, GATEWAY_M, with_gateway
from sim.shapes.house_mesh import FOUNDATION_M, atlas_width_m, house_mesh
from sim.shapes.mesh import Mesh
from sim.shapes.sweep import along_section, sweep

FRONT_M = np.array([[0.0, 0.0], [9.0, 0.0]])
BACK_M = np.array([[0.0, 6.0], [9.0, 6.0]])


def house(seed: int, corner: bool = False) -> tuple[Facade, Mesh]:
    facade = draw_facade(9.0, np.random.default_rng(seed), corner=corner)
    return facade, house_mesh(facade, FRONT_M, BACK_M, 0.03, (corner, corner))


def facing(mesh: Mesh, direction: tuple[float, float, float]) -> float:
    """Area of the triangles that look along a direction."""
    a, b, c = (mesh.vertices_m[mesh.faces[:, k]] for k in range(3))
    return float(np.clip(np.cross(b - a, c - a) @ direction, 0, None).sum() / 2)


@pytest.mark.parametrize("seed", range(6))
def test_a_house_has_walls_on_all_sides_and_a_roof(seed: int) -> None:
    facade, mesh = house(seed)
    for direction, width in (((0, -1, 0), 9.0), ((0, 1, 0), 9.0), ((1, 0, 0), 6.0), ((-1, 0, 0), 6.0)):
        assert facing(mesh, direction) >= 0.99 * width * facade.height_m
    assert facing(mesh, (0, 0, 1)) >= 0.99 * 9.0 * 6.0


@pytest.mark.parametrize("seed", range(6))
def test_a_pitched_roof_rises_above_its_eaves_and_a_flat_one_does_not(seed: int) -> None:
    facade, mesh = house(seed)
    above = mesh.vertices_m[:, 2].max() - facade.height_m
    assert above < 0.1 if facade.roof.kind == "flat" else above >= facade.roof.ridge_m


def test_a_house_reaches_into_the_ground_for_slopes() -> None:
    assert house(0)[1].vertices_m[:, 2].min() == pytest.approx(-FOUNDATION_M)


def test_a_corner_house_has_windows_in_relief_on_its_sides() -> None:
    plain, corner = house(3)[1], house(3, corner=True)[1]
    assert not any(house(3)[0].flanks)
    assert len(corner.faces) > len(plain.faces) + 40


@pytest.mark.parametrize("seed", range(4))
def test_no_two_sides_of_a_corner_house_are_alike(seed: int) -> None:
    rng = np.random.default_rng(seed)
    facade = draw_facade(9.0, rng, corner=True)
    image = paint_facade(facade, 0.05, rng)
    starts = [round(facade.flank_m(k) / 0.05) for k in range(3)]
    sides = [image[:, start : start + 120].astype(float) for start in starts]
    for one, other in itertools.combinations(sides, 2):
        assert (np.abs(one - other).mean(axis=2) > 15).mean() > 0.1


def test_each_side_of_a_corner_house_shows_its_own_part_of_the_texture() -> None:
    facade, mesh = house(3, corner=True)
    a, b, c = (mesh.vertices_m[mesh.faces[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    walls = (mesh.vertices_m[mesh.faces][..., 2] > -0.1).all(axis=1)
    ends_m = []
    for direction in ((-1.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)):
        facing_it = walls & (normals @ direction > 0.99 * np.linalg.norm(normals, axis=1))
        x_m = mesh.uvs[mesh.faces[facing_it], 0] * atlas_width_m(facade)
        ends_m.append(x_m[x_m <= facade.walls_m].max())  # beyond it is roof
    assert ends_m == pytest.approx([facade.flank_m(k) + FLANK_M for k in range(3)], abs=0.1)


def test_a_canyon_is_twice_as_high_and_a_plain_house_has_few_panels() -> None:
    town = [draw_facade(8.0, np.random.default_rng(k), floors=OLD_TOWN) for k in range(8)]
    tall = [draw_facade(8.0, np.random.default_rng(k), floors=CANYON) for k in range(8)]
    bare = [draw_plain_house(8.0, np.random.default_rng(k)) for k in range(8)]
    assert np.mean([f.height_m for f in tall]) > 2 * np.mean([f.height_m for f in town])
    assert np.mean([len(f.panels) for f in bare]) < 0.5 * np.mean([len(f.panels) for f in town])


def test_a_wall_swept_along_a_line_is_seen_from_its_right() -> None:
    line = np.column_stack([np.linspace(0, 10, 6), np.zeros(6), np.zeros(6)])
    section = np.array([[0.0, 0.0], [0.0, 2.0]])
    mesh = sweep(line, section, np.linspace(0, 1, 6), along_section(section))
    assert facing(mesh, (0, -1, 0)) == pytest.approx(20.0)
    assert facing(mesh, (0, 1, 0)) == 0.0


@pytest.mark.parametrize("is_plain", (False, True))
@pytest.mark.parametrize("seed", range(4))
def test_nothing_of_a_front_is_left_in_its_gateway(seed: int, is_plain: bool) -> None:
    rng = np.random.default_rng(seed)
    if is_plain:
        whole = draw_plain_house(14.0, rng, floors=(1,))
    else:
        whole = draw_facade(14.0, rng, shops=False, floors=GATE_FLOORS)
    cut = with_gateway(whole, 7.0)
    gateway = cut.panels[-1]
    assert (gateway.x1 - gateway.x0, gateway.z0, gateway.z1) == (7.0, 0.0, GATEWAY_M)
    assert gateway.z1 < cut.height_m
    for panel in cut.panels[:-2]:  # the last but one is its frame
        beside = panel.x1 <= gateway.x0 or panel.x0 >= gateway.x1
        assert beside or panel.z0 >= gateway.z1, panel
    assert any(panel.kind == "window" for panel in cut.panels)
