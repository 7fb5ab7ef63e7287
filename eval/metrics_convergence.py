"""When the rig was found: from then on every camera stays within the limits."""

from __future__ import annotations

from eval.collect import RunLog
from eval.errors import PoseError
from eval.metric import Missing, Value
from eval.metric_keys import NO_TRUTH
from eval.metrics_extrinsics import camera_errors
from eval.paths import driven_m
from eval.truth import TruthTrack

ROTATION_LIMIT_DEG = 0.1
TRANSLATION_LIMIT_MM = 20.0


def convergence_metrics(log: RunLog, truth: TruthTrack | None) -> dict[str, Value]:
    """Return ``convergence.*``: time and distance from the first bundle until all stays within."""
    keys = ("convergence.time_s", "convergence.distance_m")
    if truth is None:
        return dict.fromkeys(keys, Missing(NO_TRUTH))
    first_good = first_lasting(_bundles_within(log, truth))
    if first_good is None:
        reason = f"not every camera stayed within {ROTATION_LIMIT_DEG} deg and {TRANSLATION_LIMIT_MM:.0f} mm"
        return dict.fromkeys(keys, Missing(reason))
    driven = driven_m(log, truth)
    distance: Value = Missing("the distance driven is not known") if driven is None else driven[first_good]
    return dict(
        zip(keys, ((log.entries[first_good].stamp_ns - log.first_stamp_ns) * 1e-9, distance), strict=True)
    )


def within_limits(error: PoseError | Missing) -> bool:
    """Tell whether a camera counts as found."""
    if isinstance(error, Missing):
        return False
    return error.rotation_deg <= ROTATION_LIMIT_DEG and error.translation_mm <= TRANSLATION_LIMIT_MM


def first_lasting(good: list[bool]) -> int | None:
    """Return the first index from which on all is good; None where the last is not."""
    bad = [index for index, is_good in enumerate(good) if not is_good]
    first = bad[-1] + 1 if bad else 0
    return first if first < len(good) else None


def _bundles_within(log: RunLog, truth: TruthTrack) -> list[bool]:
    names = log.rig.estimated_names
    every = (camera_errors(entry.cameras, truth, entry.stamp_ns, names) for entry in log.entries)
    return [all(within_limits(error) for error in errors.values()) for errors in every]
