"""What the estimate cost, and the real-time figures, which only a run on the wall clock has."""

from __future__ import annotations

from eval.collect import RunLog
from eval.metric import Missing, Value

_LOCK_STEP = Missing("the run was in lock-step; real time is measured on the wall clock")
_REALTIME_KEYS = (
    "realtime.bundle_hz",
    "realtime.latency_p50_ms",
    "realtime.latency_p99_ms",
    "realtime.dropped_bundles",
)


def cost_metrics(log: RunLog) -> dict[str, Value]:
    """Return ``cost.*``."""
    if log.cpu_s is None:
        return dict.fromkeys(("cost.cpu_s", "cost.peak_rss_mb"), Missing("the calls were not measured"))
    return {"cost.cpu_s": log.cpu_s, "cost.peak_rss_mb": log.usage.peak_rss_mb}


def realtime_metrics() -> dict[str, Value]:
    """Return ``realtime.*`` of a run in lock-step."""
    return dict.fromkeys(_REALTIME_KEYS, _LOCK_STEP)
