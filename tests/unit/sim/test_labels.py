from __future__ import annotations

import mujoco
import numpy as np
import pytest

from sim.channels.labels import CLASSES, class_named, label_geoms
from sim.rendering.geom_picture import SKY
from sim.seeds import rng_for
from sim.streets.street import StreetConfig, build_street

WORLD = """
<mujoco><asset><material name="skin_house_3"/><material name="skin_road_main_0_1"/></asset><worldbody>
  <geom name="scenery_house_3" type="box" size="1 1 1" material="skin_house_3"/>
  <geom name="scenery_road_1" type="box" size="1 1 1" material="skin_road_main_0_1"/>
  <geom name="strange" type="box" size="1 1 1"/>
  <body name="chassis"><freejoint/><geom type="box" size="1 1 1"/>
    <body name="front_left_wheel"><geom type="box" size="1 1 1"/></body></body>
  <body name="pedestrian_2" mocap="true"><geom type="box" size="1 1 1"/>
    <geom type="box" size="1 1 1"/></body>
</worldbody></mujoco>
"""


def test_classes_follow_names_and_all_parts_of_a_mover_are_one_instance() -> None:
    labels = label_geoms(mujoco.MjModel.from_xml_string(WORLD))
    geoms = np.array([0, 1, 2, 3, 4, 5, 6, SKY], np.int32)
    assert [CLASSES[index] for index in labels.classes(geoms)] == [
        "building",
        "road",
        "other",
        "own_car",
        "own_car",
        "person",
        "person",
        "sky",
    ]
    names = [labels.instance_names[index] for index in labels.instances(geoms)]
    assert names[:3] == ["scenery_house_3", "scenery_road_1", "strange"]
    assert names[3:] == ["chassis", "chassis", "pedestrian_2", "pedestrian_2", "sky"]


@pytest.mark.parametrize("kind", ["motorway", "tunnel", "suburb", "car_park"])
def test_all_that_stands_in_a_street_has_a_class(kind: str) -> None:
    config = StreetConfig.model_validate({"kind": kind, "length_m": 100})
    scenery = build_street(config, rng_for(0, "street")).scenery
    assert {prop.skin for prop in scenery.props if class_named(prop.skin) == "other"} == set()
