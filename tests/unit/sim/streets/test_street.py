"""The whole street: determinism, and that nothing stands where it must not."""

import hashlib
import itertools

import mujoco
import numpy as np
import pytest

from sim.streets.footprint import gap_m, rectangle_m
from sim.streets.street import Street, StreetConfig, build_street

DRIVEN_HALF_M = 1.3


def build(seed: int, length_m: float = 20.0) -> Street:
    return build_street(StreetConfig(length_m=length_m), np.random.default_rng(seed))


@pytest.fixture(scope="module")
def streets() -> dict[int, Street]:
    return {seed: build(seed) for seed in (0, 1)}


@pytest.fixture(params=[0, 1])
def street(streets: dict[int, Street], request: pytest.FixtureRequest) -> Street:
    return streets[request.param]


def digest(street: Street) -> str:
    found = hashlib.sha256(street.centerline_m.tobytes())
    for prop in street.scenery.props:
        found.update(repr((prop.name, prop.skin, prop.position_m, prop.yaw_rad)).encode())
        for part in (prop.mesh.vertices_m, prop.mesh.normals, prop.mesh.uvs, prop.mesh.faces):
            found.update(np.ascontiguousarray(part).tobytes())
    for name, skin in street.scenery.skins.items():
        found.update(name.encode() + skin.image.tobytes())
    return found.hexdigest()


def test_the_same_seed_builds_the_same_street_and_another_seed_another(streets: dict[int, Street]) -> None:
    assert digest(streets[0]) == digest(build(0))
    assert digest(streets[0]) != digest(streets[1])


def test_nothing_stands_on_the_driven_corridor(street: Street) -> None:
    line = street.centerline_m[::4]
    ahead = np.diff(line, axis=0)
    for prop in street.scenery.props:
        if prop.footprint_m is None:
            continue
        for at, step in zip(line[:-1], ahead, strict=True):
            if np.linalg.norm(prop.footprint_m.mean(axis=0) - at) < 15.0:
                corridor = rectangle_m(at, float(np.arctan2(step[1], step[0])), 1.2, 2 * DRIVEN_HALF_M)
                assert gap_m(prop.footprint_m, corridor) > 0.0, prop.name


def test_no_mesh_below_head_height_reaches_into_the_corridor(street: Street) -> None:
    line = street.centerline_m
    for prop in street.scenery.props:
        if prop.footprint_m is None:
            continue
        vertices = prop.mesh.moved(prop.position_m, prop.yaw_rad).vertices_m
        low = vertices[(vertices[:, 2] < 1.7) & (vertices[:, 2] > 0.01), :2]
        if len(low) and np.linalg.norm(line - low.mean(axis=0), axis=1).min() < 15.0:
            away = np.linalg.norm(low[:, None] - line[None], axis=2).min()
            assert away > DRIVEN_HALF_M, prop.name


def test_things_do_not_stand_in_each_other(street: Street) -> None:
    standing = [prop for prop in street.scenery.props if prop.footprint_m is not None]
    for one, other in itertools.combinations(standing, 2):
        if np.linalg.norm(one.footprint_m.mean(axis=0) - other.footprint_m.mean(axis=0)) < 25.0:
            assert gap_m(one.footprint_m, other.footprint_m) > -0.02, (one.name, other.name)


def test_every_prop_has_a_skin_and_a_sound_mesh(street: Street) -> None:
    names = [prop.name for prop in street.scenery.props]
    assert len(set(names)) == len(names)
    for prop in street.scenery.props:
        mesh = prop.mesh
        assert prop.skin in street.scenery.skins
        assert np.isfinite(mesh.vertices_m).all()
        np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1.0, atol=1e-6, err_msg=prop.name)
        assert mesh.faces.max() < len(mesh.vertices_m)


def test_scenery_compiles_and_collides_with_nothing(street: Street) -> None:
    spec = mujoco.MjSpec()
    street.write_into(spec)
    model = spec.compile()
    assert model.ngeom == len(street.scenery.props)
    assert not model.geom_contype.any()
    assert not model.geom_conaffinity.any()


def test_the_road_lies_in_the_plane_and_pavements_a_kerb_above(street: Street) -> None:
    roads = [p for p in street.scenery.props if p.name.startswith(("road_", "side_road_"))]
    pavements = [p for p in street.scenery.props if "pavement" in p.name]
    assert roads and pavements
    assert all((prop.mesh.vertices_m[:, 2] == 0.0).all() for prop in roads)
    assert all(prop.mesh.vertices_m[:, 2].max() == pytest.approx(0.12) for prop in pavements)


def test_houses_differ(street: Street) -> None:
    images = [skin.image for name, skin in street.scenery.skins.items() if name.startswith("house_")]
    assert len(images) > 20
    assert len({image.tobytes() for image in images}) == len(images)
