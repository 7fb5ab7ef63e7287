"""Whether the estimator noticed cameras that moved.

A camera has moved when its true pose is further than 0.1 deg or 20 mm from where it was at the start, or
since its last move. The alarm is a change of its status to ``moved``.
"""

from __future__ import annotations

import numpy as np

from estimator.estimate import Status
from eval.collect import RunLog
from eval.errors import pose_error
from eval.metric import Missing, Value
from eval.metric_keys import NO_TRUTH
from eval.metrics_convergence import within_limits
from eval.truth import TruthTrack

_KEYS = ("alarm.delay_s", "alarm.false_count", "alarm.missed_count")


def alarm_metrics(log: RunLog, truth: TruthTrack | None) -> dict[str, Value]:
    """Return ``alarm.*``; false alarms count on every drive, delay and misses only where a camera moved."""
    if truth is None:
        return dict.fromkeys(_KEYS, Missing(NO_TRUTH))
    delays_s: list[float] = []
    false_count = move_count = 0
    for name in log.rig.estimated_names:
        moves, alarms = true_moves_ns(log, truth, name), alarms_ns(log, name)
        answers = _first_answers_ns(moves, alarms)
        delays_s += [(answer - move) * 1e-9 for move, answer in answers.items()]
        false_count += len(alarms) - len(answers)
        move_count += len(moves)
    still = Missing("no camera moved in this drive")
    none_seen = Missing("no move was noticed") if move_count else still
    return {
        "alarm.delay_s": float(np.mean(delays_s)) if delays_s else none_seen,
        "alarm.false_count": float(false_count),
        "alarm.missed_count": float(move_count - len(delays_s)) if move_count else still,
    }


def true_moves_ns(log: RunLog, truth: TruthTrack, name: str) -> list[int]:
    """Return the stamps of the bundles at which a camera had newly moved."""
    moves: list[int] = []
    rest = None
    for stamp in log.stamps_ns:
        pose = truth.ego_from_cams_at(stamp).get(name)
        if pose is None:
            continue
        if rest is not None and not within_limits(pose_error(rest, pose)):
            moves.append(stamp)
            rest = pose
        rest = rest or pose
    return moves


def alarms_ns(log: RunLog, name: str) -> list[int]:
    """Return the stamps at which a camera's status became ``moved``."""
    alarms: list[int] = []
    before = False
    for entry in log.entries:
        camera = entry.cameras.get(name)
        now = camera is not None and camera.status is Status.MOVED
        if now and not before:
            alarms.append(entry.stamp_ns)
        before = now
    return alarms


def _first_answers_ns(moves: list[int], alarms: list[int]) -> dict[int, int]:
    """Return, by move, the first alarm between it and the next move."""
    answers: dict[int, int] = {}
    for alarm in alarms:
        earlier = [move for move in moves if move <= alarm]
        if earlier and earlier[-1] not in answers:
            answers[earlier[-1]] = alarm
    return answers
