from __future__ import annotations

import mujoco
import numpy as np
import pytest
import trimesh

from sim.rendering.linear_light import lamp_light, shines, sky_light
from sim.rendering.model_meshes import drawn_geoms, surface_of, texture_image, world_from_geom
from sim.rendering.sky_texture import sky_color

SHAPES = """
<mujoco><asset>
  <texture name="stripes" type="2d" builtin="checker" width="6" height="4" rgb1="1 0 0" rgb2="0 0 1"/>
  <material name="painted" texture="stripes" emission="0.5"/>
  <mesh name="wedge" vertex="0 0 0  2 0 0  0 1 0  0 0 3"/>
</asset><worldbody>
  <geom name="box" type="box" size="1 2 3"/>
  <geom name="ball" type="sphere" size="0.5" rgba="0 1 0 1"/>
  <geom name="egg" type="ellipsoid" size="1 2 0.5"/>
  <geom name="can" type="cylinder" size="0.4 1.5"/>
  <geom name="pill" type="capsule" size="0.4 1.5"/>
  <geom name="wedge" type="mesh" mesh="wedge" pos="5 6 7" material="painted"/>
  <geom name="unseen" type="box" size="1 1 1" group="4"/>
  <geom name="clear" type="box" size="1 1 1" rgba="1 1 1 0"/>
</worldbody></mujoco>
"""


@pytest.fixture(scope="module")
def model() -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_string(SHAPES)


@pytest.mark.parametrize(
    ("name", "extents_m"),
    [
        ("box", [2, 4, 6]),
        ("ball", [1, 1, 1]),
        ("egg", [2, 4, 1]),
        ("can", [0.8, 0.8, 3]),
        ("pill", [0.8, 0.8, 3.8]),
    ],
)
def test_shapes_have_mujocos_size_and_face_outwards(
    model: mujoco.MjModel, name: str, extents_m: list[float]
) -> None:
    surface = surface_of(model, model.geom(name).id)
    np.testing.assert_allclose(np.ptp(surface.vertices_geom, axis=0), extents_m, rtol=0.01)
    np.testing.assert_allclose(surface.vertices_geom.mean(0), 0, atol=0.05)
    triangles = surface.vertices_geom[surface.faces]
    outward = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    assert (np.einsum("ij,ij->i", outward, triangles.mean(1)) > 0).all()
    assert (np.einsum("ij,ij->i", surface.normals_geom, surface.vertices_geom) > 0).all()


def test_a_mesh_stands_where_it_was_put_though_compiling_moves_its_origin(model: mujoco.MjModel) -> None:
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    geom = model.geom("wedge").id
    corners = trimesh.transform_points(surface_of(model, geom).vertices_geom, world_from_geom(data, geom))
    np.testing.assert_allclose(corners.min(0), [5, 6, 7], atol=1e-6)
    np.testing.assert_allclose(corners.max(0), [7, 7, 10], atol=1e-6)


def test_only_what_mujoco_draws_is_drawn(model: mujoco.MjModel) -> None:
    names = [model.geom(geom).name for geom in drawn_geoms(model)]
    assert names == ["box", "ball", "egg", "can", "pill", "wedge"]


def test_colour_emission_and_texture_come_from_the_model(model: mujoco.MjModel) -> None:
    assert surface_of(model, model.geom("ball").id).rgba.tolist() == [0, 1, 0, 1]
    wedge = surface_of(model, model.geom("wedge").id)
    assert wedge.emission == 0.5 and wedge.texture is None, "it has no texture coordinates"
    image = texture_image(model, 0)
    assert image.shape == (4, 6, 3) and {tuple(pixel) for pixel in image.reshape(-1, 3)} == {
        (255, 0, 0),
        (0, 0, 255),
    }


def test_fill_light_counts_as_sky_and_lamps_fade_with_distance() -> None:
    model = mujoco.MjModel.from_xml_string(
        """<mujoco><visual><headlight ambient="0.2 0.2 0.2"/></visual><worldbody>
        <light name="fill" type="directional" castshadow="false" diffuse="0.4 0.4 0.4"/>
        <light name="sun" type="directional" diffuse="1 0.5 0.25"/>
        <light name="even" type="spot" diffuse="1 1 1"/>
        <light name="fading" type="spot" diffuse="1 1 1" attenuation="0 0 1"/>
        <light name="off" type="spot" diffuse="1 1 1" active="false"/>
        </worldbody></mujoco>"""
    )
    assert [shines(model, index) for index in range(5)] == [False, True, True, True, True]
    assert sky_light(model)[0] == pytest.approx(1.2 * 0.3**2.2)
    sun = lamp_light(model, 1)
    assert sun[0] > sun[1] > sun[2] and sun[0] == pytest.approx(1.2)
    assert lamp_light(model, 2)[0] == pytest.approx(25 * lamp_light(model, 3)[0])
    assert lamp_light(model, 4).tolist() == [0, 0, 0]


def test_each_direction_finds_its_face_of_the_sky() -> None:
    faces = np.repeat(np.arange(6, dtype=np.uint8), 8 * 8).reshape(48, 8, 1).repeat(3, axis=2)
    directions = np.array([[1, 0, 0], [-1, 0, 0], [0, 0, 1], [0, 0, -1], [0, -1, 0], [0, 1, 0]], float)
    colors = sky_color(faces, directions + 0.1)  # right, left, up, down, front (world -y), back
    assert colors[:, 0].tolist() == [0, 1, 2, 3, 4, 5]
