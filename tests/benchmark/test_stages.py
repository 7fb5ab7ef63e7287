"""How long the stages of the main job take, on one short drive and in one process.

Prints milliseconds a bundle; asserts only ratios within this run, because machines differ.
"""

import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from estimator.online import OnlineEstimator
from estimator.recording import Recording
from scenarios.load import load_scenario
from scenarios.scenario import Scenario
from sim.recorder import record

Stages = dict[str, float]


@pytest.fixture(scope="module")
def bundle_ms(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Stages]:
    """Wall milliseconds a bundle, by stage."""
    scenario = load_scenario("quick_look")
    bag = tmp_path_factory.mktemp("bench") / "bag"
    stages = _rendering(scenario, bag) | _reading(scenario, bag) | _estimating(scenario, bag)
    print("\n" + "\n".join(f"{stage:<28}{value:9.1f} ms" for stage, value in stages.items()))
    yield stages


def _rendering(scenario: Scenario, bag: Path) -> Stages:
    ends_s: list[float] = []
    started_s = time.perf_counter()
    record(scenario.world, scenario.rig, 0, bag, lambda done, total: ends_s.append(time.perf_counter()))
    render_s = (ends_s[-1] - ends_s[0]) / (len(ends_s) - 1)
    build_s = ends_s[0] - started_s - render_s
    return {"build the street, once": 1000 * build_s, "render and record a bundle": 1000 * render_s}


def _reading(scenario: Scenario, bag: Path) -> Stages:
    with Recording(bag, scenario.rig) as recording:
        started_s = time.perf_counter()
        count = sum(1 for _ in recording.bundles())
        return {"read a bundle": 1000 * (time.perf_counter() - started_s) / count}


def _estimating(scenario: Scenario, bag: Path) -> Stages:
    with Recording(bag, scenario.rig) as recording:
        bundles = list(recording.bundles())
    estimator = OnlineEstimator(scenario.rig)
    started_s = time.perf_counter()
    for bundle in bundles:
        estimator.update(bundle)
    updated_s = time.perf_counter()
    estimator.close()
    return {
        "update with a bundle, mean": 1000 * (updated_s - started_s) / len(bundles),
        "close, once": 1000 * (time.perf_counter() - updated_s),
    }


def test_reading_a_bundle_is_far_cheaper_than_rendering_it(bundle_ms: Stages) -> None:
    assert bundle_ms["read a bundle"] < 0.2 * bundle_ms["render and record a bundle"]
