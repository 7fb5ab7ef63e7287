"""Write the folder of a run, whole or not at all.

Files: ``scores.json``, ``extrinsics.csv``, ``rig.yaml``, ``trajectory.tum``, ``truth.tum`` (with truth only),
``events.jsonl``, ``report.html``, and ``report_data.json`` from which the report can be made again.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from estimator.rig import Rig
from estimator.rig_file import rig_to_yaml
from eval.collect import RunLog
from eval.header import RunHeader
from eval.json_text import json_text
from eval.metric import Metric
from eval.out_folder import creating
from eval.paths import estimated_path, true_path
from eval.report import write_report
from eval.report_data import report_data
from eval.tables import events_jsonl, extrinsics_csv, tum
from eval.truth import TruthTrack

SCHEMA = 1


def write_run_folder(
    folder: Path,
    log: RunLog,
    metrics: Mapping[str, Metric],
    header: RunHeader,
    rig_nominal: Rig,
    truth: TruthTrack | None,
) -> None:
    """Write all files into a sibling of ``folder``, which must not exist, and rename it.

    Raises:
        InputError: The folder exists or cannot be written.
    """
    with creating(folder) as partial:
        partial.mkdir()
        for name, text in _texts(log, metrics, header, rig_nominal, truth).items():
            (partial / name).write_text(text, encoding="utf-8", newline="\n")
        write_report(partial)


def final_rig(log: RunLog, rig_nominal: Rig) -> Rig:
    """Return the rig as estimated, with refined intrinsics where there are any.

    The pose of the reference, and of a camera without a finite one, stays nominal.
    """
    found = {
        name: log.final.cameras[name].ego_from_cam
        for name in rig_nominal.estimated_names
        if name in log.final.cameras and np.isfinite(log.final.cameras[name].ego_from_cam.matrix).all()
    }
    lenses = {name: log.final.cameras[name].camera for name in log.final.cameras}
    cameras = {
        name: replace(mounted, camera=lenses.get(name) or mounted.camera)
        for name, mounted in rig_nominal.with_extrinsics(found).cameras.items()
    }
    return replace(rig_nominal, cameras=cameras)


def scores_json(metrics: Mapping[str, Metric], header: RunHeader) -> dict[str, Any]:
    """Return the content of ``scores.json``."""
    return {
        "schema": SCHEMA,
        "scenario": header.scenario,
        "digest": header.digest,
        "seed": header.seed,
        "estimator": header.estimator,
        "settings": dict(header.settings),
        "provenance": dict(header.provenance),
        "metrics": {key: metric.to_json() for key, metric in metrics.items()},
    }


def _texts(
    log: RunLog,
    metrics: Mapping[str, Metric],
    header: RunHeader,
    rig_nominal: Rig,
    truth: TruthTrack | None,
) -> dict[str, str]:
    texts = {
        "scores.json": json_text(scores_json(metrics, header), indent=2),
        "extrinsics.csv": extrinsics_csv(log),
        "rig.yaml": rig_to_yaml(final_rig(log, rig_nominal)),
        "trajectory.tum": tum(estimated_path(log)),
        "events.jsonl": events_jsonl(log, header.warnings),
        "report_data.json": json_text(report_data(log, header, truth)),
    }
    path = true_path(truth)
    return texts if path is None else texts | {"truth.tum": tum(path)}
