"""The registry of metric keys: unit, direction and meaning of everything that ``scores.json`` may hold.

``<camera>`` stands for every camera of the rig but the reference. Every run has every key.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from eval.metric import Better

CAMERA = "<camera>"
CHECKPOINTS_M = (10, 20, 50, 100)
NO_TRUTH = "the recording holds no truth"


@dataclass(frozen=True)
class MetricKey:
    """What one key, or one pattern with ``<camera>``, means."""

    key: str
    unit: str
    better: Better
    meaning: str

    def for_camera(self, camera: str) -> MetricKey:
        return replace(
            self,
            key=self.key.replace(CAMERA, camera),
            meaning=self.meaning.replace("the camera", camera),
        )


def extrinsic_key(camera: str, quantity: str, checkpoint_m: int | None = None) -> str:
    """Name an extrinsic metric: of a camera, ``worst`` or ``median``; final, or at a checkpoint."""
    suffix = "" if checkpoint_m is None else f".at_{checkpoint_m}m"
    return f"extrinsics.{camera}.{quantity}{suffix}"


def _extrinsic_keys(camera: str, whose: str) -> Iterator[MetricKey]:
    texts = {"rotation_deg": ("deg", "rotation error"), "translation_mm": ("mm", "translation error")}
    for quantity, (unit, what) in texts.items():
        final = f"{what} of {whose}: the final estimate against truth at the last stamp"
        yield MetricKey(extrinsic_key(camera, quantity), unit, "lower", final)
        for checkpoint in CHECKPOINTS_M:
            online = f"{what} of {whose} when the car had driven {checkpoint} m"
            yield MetricKey(extrinsic_key(camera, quantity, checkpoint), unit, "lower", online)


def _bound_key(camera: str, whose: str) -> MetricKey:
    meaning = f"error of {whose} in units of the best any estimator could reach: sqrt(e' inv(bound) e / 6)"
    return MetricKey(f"extrinsics.{camera}.bound_ratio", "1", "lower", meaning)


_PER_CAMERA = (*_extrinsic_keys(CAMERA, "the camera"), _bound_key(CAMERA, "the camera"))
_OVER_CAMERAS = (
    *_extrinsic_keys("worst", "the worst camera"),
    _bound_key("worst", "the worst camera"),
    *_extrinsic_keys("median", "the median camera"),
)
_WHOLE_RUN = (
    MetricKey("convergence.time_s", "s", "lower", "from then on every camera stays within 0.1 deg and 20 mm"),
    MetricKey("convergence.distance_m", "m", "lower", "distance driven at convergence.time_s"),
    MetricKey("consistency.nees", "1", "lower", "mean over cameras of e' inv(Sigma) e / 6; honest is near 1"),
    MetricKey("consistency.coverage95", "1", "higher", "share of cameras inside their stated 95 % region"),
    MetricKey("motion.ate_m", "m", "lower", "RMS distance of the two paths after rigid alignment"),
    MetricKey("motion.rpe_translation_percent", "%", "lower", "mean drift over segments of 5 to 200 m"),
    MetricKey("motion.rpe_rotation_deg_per_m", "deg/m", "lower", "mean turn error over the same segments"),
    MetricKey("motion.scale_error_percent", "%", "lower", "how much too long or short the estimated path is"),
    MetricKey("alarm.delay_s", "s", "lower", "mean time from a camera's move to its status 'moved'"),
    MetricKey("alarm.false_count", "1", "lower", "times a camera was called moved and had not"),
    MetricKey("alarm.missed_count", "1", "lower", "moves that no status 'moved' answered"),
    MetricKey("realtime.bundle_hz", "Hz", "higher", "bundles processed a second, on the wall clock"),
    MetricKey("realtime.latency_p50_ms", "ms", "lower", "median time from due to answered"),
    MetricKey("realtime.latency_p99_ms", "ms", "lower", "99th percentile of the same"),
    MetricKey("realtime.dropped_bundles", "1", "lower", "bundles that came too fast and were dropped"),
    MetricKey("cost.cpu_s", "s", "lower", "CPU time inside the estimator, all its threads and processes"),
    MetricKey("cost.peak_rss_mb", "MB", "lower", "highest memory of the process that runs it, and children"),
)


def key_patterns() -> tuple[MetricKey, ...]:
    """Return the registry with ``<camera>`` unexpanded, for people to read."""
    return (*_PER_CAMERA, *_OVER_CAMERAS, *_WHOLE_RUN)


def keys_for(cameras: Sequence[str]) -> tuple[MetricKey, ...]:
    """Return every key of a run whose estimated cameras are ``cameras``, in the order of ``scores.json``."""
    expanded = (pattern.for_camera(camera) for camera in cameras for pattern in _PER_CAMERA)
    return (*_OVER_CAMERAS, *expanded, *_WHOLE_RUN)
