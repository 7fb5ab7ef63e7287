"""How well the car's own path was found, from the refined trajectory where the estimator gives one.

The estimated world has its own origin and heading, so the absolute error is taken after a rigid
alignment; the relative errors need none.
"""

from __future__ import annotations

import numpy as np

from eval.align import align
from eval.collect import RunLog
from eval.metric import Missing, Value
from eval.metric_keys import NO_TRUTH
from eval.paths import estimated_path, true_path
from eval.trajectory import Trajectory
from eval.truth import TruthTrack

SEGMENTS_M = (5.0, 10.0, 20.0, 50.0, 100.0, 200.0)
_MAX_STARTS = 500
_MIN_PATH_M = 1.0
_KEYS = (
    "motion.ate_m",
    "motion.rpe_translation_percent",
    "motion.rpe_rotation_deg_per_m",
    "motion.scale_error_percent",
)


def motion_metrics(log: RunLog, truth: TruthTrack | None) -> dict[str, Value]:
    """Return ``motion.*``."""
    true = true_path(truth)
    if true is None:
        return dict.fromkeys(_KEYS, Missing(NO_TRUTH))
    paths = paired(estimated_path(log), true)
    if paths is None:
        return dict.fromkeys(_KEYS, Missing("fewer than 3 estimated poses lie within the true path"))
    estimated, true = paths
    return absolute_errors(estimated, true) | relative_errors(estimated, true)


def paired(estimated: Trajectory, true: Trajectory) -> tuple[Trajectory, Trajectory] | None:
    """Return both paths at the estimated stamps that truth covers; None below 3 of them."""
    covered = true.covers(estimated.stamps_ns)
    if int(covered.sum()) < 3:
        return None
    kept = Trajectory(
        estimated.stamps_ns[covered], estimated.positions_world[covered], estimated.rotations[covered]
    )
    return kept, true.at(kept.stamps_ns)


def absolute_errors(estimated: Trajectory, true: Trajectory) -> dict[str, Value]:
    """Return the RMS distance after rigid alignment, and how far the aligning scale is from 1.

    Reference:
        Sturm et al. 2012, sec. VI (absolute trajectory error).
    """
    alignment = align(estimated.positions_world, true.positions_world)
    aligned = alignment.true_from_estimated.apply(estimated.positions_world)
    squared = ((aligned - true.positions_world) ** 2).sum(axis=1)
    scale_error: Value
    if alignment.scale is None or alignment.scale <= 0 or true.distance_m[-1] < _MIN_PATH_M:
        scale_error = Missing(f"a path must be {_MIN_PATH_M:.0f} m long to show its scale")
    else:
        scale_error = 100 * abs(1 / alignment.scale - 1)
    return {"motion.ate_m": float(np.sqrt(squared.mean())), "motion.scale_error_percent": scale_error}


def relative_errors(estimated: Trajectory, true: Trajectory) -> dict[str, Value]:
    """Return the mean drift over all segments of 5, 10, 20, 50, 100 and 200 m of true path.

    Starts are all poses, thinned to 500. Each segment's error is divided by its own true length.

    Reference:
        Geiger, Lenz & Urtasun 2012, sec. 3.2, with shorter segments.
    """
    driven = true.distance_m
    starts = np.arange(0, len(true), max(1, len(true) // _MAX_STARTS))
    drifts: list[tuple[float, float]] = []
    for segment_m in SEGMENTS_M:
        ends = np.searchsorted(driven, driven[starts] + segment_m)
        inside = ends < len(true)
        pairs = zip(starts[inside], ends[inside], strict=True)
        drifts += [_drift(estimated, true, int(start), int(end)) for start, end in pairs]
    keys = ("motion.rpe_translation_percent", "motion.rpe_rotation_deg_per_m")
    if not drifts:
        reason = f"the drive is {driven[-1]:.1f} m long; the shortest segment is {SEGMENTS_M[0]:.0f} m"
        return dict.fromkeys(keys, Missing(reason))
    translation, rotation = np.mean(drifts, axis=0)
    return dict(zip(keys, (100 * float(translation), float(np.degrees(rotation))), strict=True))


def _drift(estimated: Trajectory, true: Trajectory, start: int, end: int) -> tuple[float, float]:
    """Return translation drift (m/m) and rotation drift (rad/m) of one segment."""
    length_m = float(true.distance_m[end] - true.distance_m[start])
    estimated_step = estimated.pose(start).inverse() @ estimated.pose(end)
    true_step = true.pose(start).inverse() @ true.pose(end)
    error = estimated_step.inverse() @ true_step
    return float(np.linalg.norm(error.translation)) / length_m, error.angle_rad / length_m
