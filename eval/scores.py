"""Score a run: every metric of the registry, each with a value or the reason why it has none."""

from __future__ import annotations

from eval.collect import RunLog
from eval.metric import Metric, Value, metric_from
from eval.metric_keys import keys_for
from eval.metrics_alarm import alarm_metrics
from eval.metrics_consistency import consistency_metrics
from eval.metrics_convergence import convergence_metrics
from eval.metrics_cost import cost_metrics, realtime_metrics
from eval.metrics_extrinsics import extrinsic_metrics
from eval.metrics_motion import motion_metrics
from eval.truth import TruthTrack


def score(log: RunLog, truth: TruthTrack | None) -> dict[str, Metric]:
    """Compute all metrics of a finished run.

    Args:
        log: What was kept of it.
        truth: The true path and extrinsics; None where the recording holds none.

    Returns:
        A metric for every key of the registry, in its order.
    """
    values: dict[str, Value] = {
        **extrinsic_metrics(log, truth),
        **convergence_metrics(log, truth),
        **consistency_metrics(log, truth),
        **motion_metrics(log, truth),
        **alarm_metrics(log, truth),
        **realtime_metrics(),
        **cost_metrics(log),
    }
    keys = keys_for(log.rig.estimated_names)
    return {entry.key: metric_from(values[entry.key], entry.unit, entry.better) for entry in keys}
