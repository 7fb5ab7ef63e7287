"""Every key, always; a value or a reason."""

import math

import pytest

from estimator.errors import InputError
from estimator.estimate import Estimate
from eval.collect import RunLog
from eval.metric import Metric, Missing, metric_from
from eval.metric_keys import key_patterns, keys_for
from eval.scores import score
from tests.unit.eval.tiny_run import RIG, SIGMA, camera_estimates, off_by, run_log, straight, truth_of


@pytest.mark.parametrize("with_truth", [True, False])
def test_no_key_is_ever_missing(with_truth):
    path = straight(60)
    metrics = score(run_log(path), truth_of(path) if with_truth else None)
    assert list(metrics) == [entry.key for entry in keys_for(RIG.estimated_names)]


def test_without_truth_only_the_cost_has_values_and_the_rest_has_reasons():
    metrics = score(run_log(straight(4)), None)
    assert {key for key, metric in metrics.items() if metric.value is not None} == {
        "cost.cpu_s",
        "cost.peak_rss_mb",
    }
    assert metrics["motion.ate_m"].reason == "the recording holds no truth"
    assert all(metric.reason for key, metric in metrics.items() if metric.value is None)


def test_with_truth_the_long_drive_has_every_value_that_applies():
    path = straight(101)
    metrics = score(run_log(path, lambda index: {"left": off_by(0.01, 1)}), truth_of(path))
    null = {
        key.split(".")[0] + "." + key.split(".")[-1] for key, each in metrics.items() if each.value is None
    }
    lock_step = {
        f"realtime.{name}" for name in ("bundle_hz", "latency_p50_ms", "latency_p99_ms", "dropped_bundles")
    }
    assert null == {"extrinsics.bound_ratio", "alarm.delay_s", "alarm.missed_count"} | lock_step


def test_a_value_that_is_not_finite_becomes_null_with_a_reason():
    assert metric_from(math.inf, "deg", "lower") == Metric(None, "deg", "lower", "the value is not finite")


def test_a_metric_is_never_both_a_value_and_a_reason():
    with pytest.raises(ValueError, match="either a value or a reason"):
        Metric(1.0, "deg", "lower", "but why")


def test_json_holds_a_reason_only_for_null():
    assert Metric(1.5, "mm", "lower").to_json() == {"value": 1.5, "unit": "mm", "better": "lower"}
    assert metric_from(Missing("so"), "mm", "lower").to_json()["reason"] == "so"


def test_every_pattern_has_a_meaning_and_there_are_no_two_alike():
    patterns = key_patterns()
    assert len({pattern.key for pattern in patterns}) == len(patterns)
    assert all(pattern.meaning for pattern in patterns)


def test_a_run_without_a_bundle_is_refused():
    with pytest.raises(InputError, match="no bundle"):
        RunLog(RIG).finish(Estimate(0, camera_estimates({}, covariance=SIGMA)))
