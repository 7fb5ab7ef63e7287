"""Many runs: expand a sweep, run what is not there yet, gather everything in one table."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import pandas as pd
from ruamel.yaml import YAML

from estimator.errors import InputError
from eval.console import Console
from eval.out_folder import make_folder
from eval.sweep_job import SweepJob, plan_job
from eval.sweep_pool import run_jobs
from eval.sweep_results import collect_rows, write_parquet
from scenarios.recordings import is_recorded
from scenarios.sweep import Sweep, load_sweep
from sim.rendering.choice import require_renderer

SWEEPS = Path("reports/sweeps")
_PLAN = "sweep.yaml"


@dataclass(frozen=True, eq=False)
class SweepResult:
    """What a sweep leaves: its folder, a row for every run and metric, and how many runs failed."""

    folder: Path
    rows: pd.DataFrame
    failure_count: int


def sweep(reference: str, workers: int, out: Path | None, console: Console) -> SweepResult:
    """Run a sweep; runs that an earlier call finished are kept.

    Raises:
        InputError: The sweep, a scenario or an estimator of it is wrong, the folder is not one of a sweep, or
            something must be rendered and this machine cannot.
    """
    plan = load_sweep(reference)
    folder = out or SWEEPS / plan.name
    jobs = [plan_job(planned, folder) for planned in plan.runs]
    waiting = [job for job in jobs if not job.is_finished()]
    _require_renderers_of(waiting)
    _open_folder(folder, plan)
    if len(waiting) < len(jobs):
        console.say(f"{len(jobs) - len(waiting)} of {len(jobs)} runs are there already")
    failures = _run_waiting(waiting, workers, console)
    rows = collect_rows(jobs, failures)
    write_parquet(rows, folder / "results.parquet")
    return SweepResult(folder, rows, len(failures))


def _require_renderers_of(jobs: list[SweepJob]) -> None:
    """Refuse once, instead of in every run, what this machine cannot render."""
    for renderer in sorted({job.renderer for job in jobs if not is_recorded(job.digest)}):
        require_renderer(renderer)


def _run_waiting(jobs: list[SweepJob], workers: int, console: Console) -> dict[SweepJob, str]:
    """Run jobs and return the reasons of those that failed."""
    failures: dict[SweepJob, str] = {}
    ended: list[SweepJob] = []

    def on_done(job: SweepJob, failure: str | None) -> None:
        ended.append(job)
        if failure is None:
            console.say(f"done: {job.request.out}")
        else:
            failures[job] = failure
            console.say(f"failed: {job.request.out}: {failure}")
        console.progress("running", len(ended), len(jobs))

    if jobs:
        console.progress("running", 0, len(jobs))
        run_jobs(jobs, min(workers, len(jobs)), on_done)
    return failures


def _is_ours(folder: Path) -> bool:
    return folder.is_dir() and ((folder / _PLAN).is_file() or not any(folder.iterdir()))


def _open_folder(folder: Path, plan: Sweep) -> None:
    """Make the folder of a sweep, or take one that is there, and write the plan into it."""
    if folder.exists() and not _is_ours(folder):
        raise InputError(f"{folder}: exists and is no sweep folder (it has no {_PLAN}); it is left as it is")
    make_folder(folder)
    partial = folder / f".{_PLAN}.partial"
    YAML(typ="safe", pure=True).dump(plan.expanded(), partial)
    partial.rename(folder / _PLAN)
