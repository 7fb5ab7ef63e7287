"""Cars, cyclists and people of a street's traffic, as the truth channels name them."""

from __future__ import annotations

from collections import defaultdict

from scenarios.load import load_scenario
from sim.channels.labels import CLASSES, label_geoms
from sim.scene import build_scene


def test_every_actor_is_one_instance_of_its_own_class() -> None:
    scenario = load_scenario("dense_traffic", ["street.length_m=60", "drive.distance_m=10"])
    labels = label_geoms(build_scene(scenario.world, scenario.rig, 0).model)
    classes = defaultdict(set)
    for number, label in zip(labels.instance_of_geom, labels.class_of_geom, strict=True):
        classes[labels.instance_names[number]].add(CLASSES[label])
    actors = {name: found for name, found in classes.items() if name.startswith("traffic_")}
    assert {frozenset(found) for found in actors.values()} == {
        frozenset({"vehicle"}),
        frozenset({"cyclist"}),
        frozenset({"person"}),
    }
    for name, found in actors.items():  # one name an actor: its kind and its number, no part's
        assert name.removeprefix("traffic_").rpartition("_")[2].isdigit()
        assert {"car": "vehicle", "cyclist": "cyclist", "pedestrian": "person"}[name.split("_")[1]] in found
        assert "part" not in name
