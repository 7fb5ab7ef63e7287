"""The first bundles of every scenario that a file of tests asks for, rendered on all cores."""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor

import pytest

from scenarios.load import load_scenario
from sim.rendering.choice import probe
from sim.world import Snapshot
from tests.scenarios.first_bundles import first_bundles, same_pictures

FirstBundles = Callable[[str], list[Snapshot]]


@pytest.fixture(scope="module")
def bundles_of(request: pytest.FixtureRequest) -> Iterator[FirstBundles]:
    """Return a scenario's first bundles; what failed there is raised here, what cannot be drawn skipped."""
    names = [
        item.callspec.params["name"]
        for item in request.session.items
        if isinstance(item, pytest.Function)
        and item.path == request.path
        and "bundles_of" in item.fixturenames
        and hasattr(item, "callspec")
    ]
    context = multiprocessing.get_context("spawn")  # OpenGL does not survive a fork
    with ProcessPoolExecutor(os.cpu_count(), mp_context=context) as pool:
        results: dict[str, Future[dict[str, list[Snapshot]]]] = {}
        for group in same_pictures(dict.fromkeys(names)):
            results |= dict.fromkeys(group, pool.submit(first_bundles, group))

        def bundles(name: str) -> list[Snapshot]:
            renderer = load_scenario(name).world.renderer
            if probe(renderer).problem:
                pytest.skip(f"this machine has no {renderer}: {probe(renderer).problem}")
            return results[name].result()[name]

        yield bundles
        pool.shutdown(cancel_futures=True)
