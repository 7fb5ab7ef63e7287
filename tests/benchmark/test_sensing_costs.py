"""Stages that render nothing keep to their limit; see ``tests.benchmark.sensing_costs`` for each."""

import cv2

from tests.benchmark.sensing_costs import WORST_OF_STAGES, developing_ms, plain_lights

LIMIT_MS = 120.0


def test_a_bundle_passes_all_stages_that_render_nothing_within_the_limit() -> None:
    """At their worst, seven images of 640 x 400, CPU time of one core."""
    threads = cv2.getNumThreads()
    cv2.setNumThreads(1)
    try:
        spent_ms = developing_ms(WORST_OF_STAGES, plain_lights())
    finally:
        cv2.setNumThreads(threads)
    print(f"\nall stages that render nothing, at their worst: {spent_ms:.0f} CPU ms a bundle")
    assert spent_ms < LIMIT_MS
