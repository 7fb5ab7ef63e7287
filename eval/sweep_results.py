"""The rows of a sweep: one for every run and metric, in a Parquet file and in a short table."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import duckdb
import pandas as pd

from eval.metric_keys import extrinsic_key, keys_for
from eval.sweep_job import SweepJob

COLUMNS = ("scenario", "seed", "estimator", "digest", "key", "value", "unit", "better", "reason")
ROTATION, TRANSLATION = (extrinsic_key("worst", quantity) for quantity in ("rotation_deg", "translation_mm"))


def collect_rows(jobs: Sequence[SweepJob], failures: Mapping[SweepJob, str]) -> pd.DataFrame:
    """Return the metrics of all runs; a failed run has every key, null, with the reason."""
    rows = [row for job in jobs for row in _rows_of(job, failures.get(job))]
    frame = pd.DataFrame(rows, columns=list(COLUMNS))
    return frame.astype({"seed": "int64", "value": "float64"})


def write_parquet(rows: pd.DataFrame, path: Path) -> None:
    """Write the rows under a temporary name and rename it."""
    partial = path.with_suffix(".partial")
    with duckdb.connect() as connection:
        connection.register("rows", rows)
        connection.execute(f"COPY rows TO '{str(partial).replace(chr(39), chr(39) * 2)}' (FORMAT parquet)")
    partial.rename(path)


def summary_rows(rows: pd.DataFrame) -> list[tuple[str, ...]]:
    """Return the worst camera of every run, and the median over the seeds of a scenario and estimator."""
    worst = rows[rows.key.isin((ROTATION, TRANSLATION))]
    table: list[tuple[str, ...]] = []
    for (scenario, estimator), group in worst.groupby(["scenario", "estimator"], sort=False):
        runs = (str(scenario), str(estimator))
        for seed, metrics in group.groupby("seed", sort=False):
            reason = next((text for text in metrics.reason if isinstance(text, str)), "")
            table.append((*runs, str(seed), *_medians(metrics), reason))
        table.append((*runs, "median", *_medians(group), ""))
    return table


def _medians(rows: pd.DataFrame) -> tuple[str, str]:
    """Return the medians of both errors as text; those of a single run are its errors."""
    rotation_deg = rows.value[rows.key == ROTATION].median()
    translation_mm = rows.value[rows.key == TRANSLATION].median()
    return _text(rotation_deg, 3), _text(translation_mm, 1)


def _rows_of(job: SweepJob, failure: str | None) -> list[tuple[Any, ...]]:
    run = (job.name, job.request.seed, job.request.estimator, job.digest)
    if failure is not None:
        return [(*run, entry.key, None, entry.unit, entry.better, failure) for entry in keys_for(job.cameras)]
    assert job.request.out is not None
    metrics = json.loads((job.request.out / "scores.json").read_text())["metrics"]
    return [
        (*run, key, entry["value"], entry["unit"], entry["better"], entry.get("reason"))
        for key, entry in metrics.items()
    ]


def _text(value: float, decimals: int) -> str:
    return "-" if pd.isna(value) else f"{value:.{decimals}f}"
