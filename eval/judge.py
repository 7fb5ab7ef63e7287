"""Estimate on a recording, score the answers, and write the run folder with its report."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from estimator.estimate import Estimate
from estimator.interface import EstimatorFactory
from estimator.recording import Recording
from estimator.rig import Rig
from eval.collect import RunLog
from eval.console import Console
from eval.estimate import estimate_recording
from eval.header import RunHeader
from eval.metric import Metric
from eval.run_folder import write_run_folder
from eval.scores import score
from eval.truth import read_truth


@dataclass(frozen=True)
class RunResult:
    """What a finished run leaves.

    Attributes:
        folder: The run folder.
        metrics: By key.
        final: The last estimate.
        rig: The nominal rig.
    """

    folder: Path
    metrics: Mapping[str, Metric]
    final: Estimate
    rig: Rig


def judge_recording(
    bag: Path,
    rig: Rig,
    make_estimator: EstimatorFactory,
    header: RunHeader,
    folder: Path,
    console: Console,
) -> RunResult:
    """Estimate, compare with truth where the bag holds it, and write everything to ``folder``.

    Raises:
        InputError: The bag or the rig is wrong.
        EstimatorError: The estimator raised.
    """
    log = RunLog(rig)
    with Recording(bag, rig) as recording:
        estimate_recording(
            recording, make_estimator, log, lambda done, total: console.progress("estimating", done, total)
        )
        header = replace(header, warnings=tuple(recording.warnings))
    for warning in header.warnings:
        console.say(f"warning: {warning}")
    truth = read_truth(bag)
    metrics = score(log, truth)
    write_run_folder(folder, log, metrics, header, rig, truth)
    return RunResult(folder, metrics, log.final, rig)
