"""When a rig counts as found."""

import pytest

from eval.metric import Missing
from eval.metrics_convergence import convergence_metrics, first_lasting
from tests.unit.eval.tiny_run import off_by, run_log, straight, truth_of


def convergence(errors_at, count=10):
    path = straight(count)
    return convergence_metrics(run_log(path, errors_at), truth_of(path))


def test_time_and_distance_count_from_the_first_bundle_to_the_first_that_stays_good():
    values = convergence(lambda index: {"rear": off_by(1.0, 0) if index < 4 else off_by(0.05, 5)})
    assert values["convergence.time_s"] == pytest.approx(0.4)
    assert values["convergence.distance_m"] == pytest.approx(4.0)


def test_a_relapse_starts_the_clock_anew():
    values = convergence(lambda index: {"left": off_by(0, 21 if index in (0, 7) else 19)})
    assert values["convergence.time_s"] == pytest.approx(0.8)


def test_one_camera_that_is_never_found_leaves_it_missing():
    value = convergence(lambda index: {"left": off_by(0.11, 0)})["convergence.time_s"]
    assert value == Missing("not every camera stayed within 0.1 deg and 20 mm")


def test_good_from_the_start_is_zero():
    assert convergence(lambda index: {})["convergence.time_s"] == 0.0


@pytest.mark.parametrize(
    ("good", "index"), [([True, True], 0), ([False, True], 1), ([True, False], None), ([False], None)]
)
def test_first_lasting_is_the_start_of_the_last_good_stretch(good, index):
    assert first_lasting(good) == index
