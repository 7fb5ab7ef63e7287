"""The main job: simulate a drive, estimate the rig from its images, score it, show it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from eval.console import Console
from eval.estimator_settings import is_of_estimator, with_settings
from eval.estimators import find_estimator
from eval.failure_log import keeping_traceback
from eval.header import RunHeader
from eval.judge import RunResult, judge_recording
from eval.out_folder import RUNS, replacing_run_folder
from eval.provenance import provenance
from scenarios.digest import recording_digest
from scenarios.load import load_scenario
from scenarios.overrides import settings_by_path
from scenarios.recordings import cached_recording


@dataclass(frozen=True)
class RunRequest:
    """What the user asks for: a scenario, a seed, an estimator, settings on top, a place for the result."""

    scenario: str
    seed: int
    estimator: str
    settings: tuple[str, ...] = ()
    out: Path | None = None


def run(request: RunRequest, console: Console) -> RunResult:
    """Run one scenario with one seed.

    Raises:
        InputError: The request is wrong.
        EstimatorError: The estimator raised.
    """
    of_scenario = [setting for setting in request.settings if not is_of_estimator(setting)]
    scenario = load_scenario(request.scenario, of_scenario, request.seed)
    make_estimator = find_estimator(request.estimator)
    make_configured = with_settings(request.estimator, make_estimator, request.settings)
    digest = recording_digest(scenario, request.seed)
    out = request.out or RUNS / run_name(scenario.name, request.seed, request.estimator)
    with replacing_run_folder(out) as folder, keeping_traceback(out):
        console.detail(f"recording {digest}")
        with cached_recording(
            scenario, request.seed, lambda done, total: console.progress("rendering", done, total)
        ) as bag:
            header = RunHeader(
                scenario.name,
                digest,
                request.seed,
                request.estimator,
                provenance(make_estimator, bag),
                scenario.about,
                settings=settings_by_path(request.settings),
            )
            result = judge_recording(bag, scenario.rig, make_configured, header, folder, console)
    return replace(result, folder=out)


def run_name(scenario: str, seed: int, estimator: str) -> str:
    """Name a run folder; ``module:Class`` becomes ``module.Class``."""
    return f"{scenario}-{seed}-{estimator.replace(':', '.')}"
