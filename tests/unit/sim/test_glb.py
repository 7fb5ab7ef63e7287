from __future__ import annotations

from pathlib import Path

import mujoco
import numpy as np
import trimesh

from sim.glb import write_glb
from tests.box_world import box_world

QUAD = """
<mujoco><asset>
  <texture name="half" type="2d" builtin="flat" width="4" height="4" rgb1="1 0 0"/>
  <material name="painted" texture="half"/>
  <mesh name="quad" inertia="shell" vertex="0 0 0  2 0 0  2 1 0  0 1 0" face="0 1 2 0 2 3"
        texcoord="0 1 1 1 1 0 0 0"/>
</asset><worldbody>
  <geom name="one" type="mesh" mesh="quad" material="painted" contype="0" conaffinity="0" pos="5 0 1"/>
  <geom name="two" type="mesh" mesh="quad" material="painted" contype="0" conaffinity="0" pos="0 7 1"/>
</worldbody></mujoco>
"""


def read_back(model: mujoco.MjModel, path: Path) -> trimesh.Scene:
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    write_glb(model, data, path)
    return trimesh.load_scene(path)


def test_things_stand_where_they_stood_with_y_up(tmp_path: Path) -> None:
    scene = read_back(mujoco.MjModel.from_xml_string(QUAD), tmp_path / "scene.glb")
    corners = {}
    for name in ("one", "two"):
        pose, mesh = scene.graph[name]
        corners[name] = trimesh.transform_points(scene.geometry[mesh].vertices, pose)
    np.testing.assert_allclose(corners["one"].min(0), [5, 1, -1], atol=1e-6)
    np.testing.assert_allclose(corners["one"].max(0), [7, 1, 0], atol=1e-6)
    np.testing.assert_allclose(corners["two"].mean(0), [1, 1, -7.5], atol=1e-6)


def test_what_looks_alike_is_stored_once_and_keeps_its_paint(tmp_path: Path) -> None:
    scene = read_back(mujoco.MjModel.from_xml_string(QUAD), tmp_path / "scene.glb")
    assert len(scene.geometry) == 1 and len(scene.graph.nodes_geometry) == 2
    (mesh,) = scene.geometry.values()
    assert np.asarray(mesh.visual.material.baseColorTexture)[0, 0, :3].tolist() == [255, 0, 0]
    x = trimesh.transform_points(mesh.vertices, scene.graph["one"][0])[:, 0]
    np.testing.assert_allclose(mesh.visual.uv[:, 0], (x - 5) / 2, atol=1e-6)


def test_boxes_and_balls_are_written_too(tmp_path: Path) -> None:
    model = box_world()
    scene = read_back(model, tmp_path / "scene.glb")
    assert len(scene.graph.nodes_geometry) == model.ngeom
    assert scene.bounds[1][1] > 3
