"""Estimate on a recording that exists, the user's own too; score it if it holds truth."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from pathlib import Path

from estimator.errors import InputError
from estimator.rig_file import read_rig
from eval.console import Console
from eval.estimator_settings import is_of_estimator, with_settings
from eval.estimators import find_estimator
from eval.failure_log import keeping_traceback
from eval.header import RunHeader
from eval.judge import RunResult, judge_recording
from eval.out_folder import RUNS, replacing_run_folder
from eval.provenance import provenance
from scenarios.checksum import folder_digest
from scenarios.overrides import settings_by_path


@dataclass(frozen=True)
class ReplayRequest:
    """A bag, the nominal rig that recorded it, an estimator, and a place for the result."""

    bag: Path
    rig: Path
    estimator: str
    out: Path | None = None
    settings: tuple[str, ...] = ()


def replay(request: ReplayRequest, console: Console) -> RunResult:
    """Estimate on one recording.

    Raises:
        InputError: The request, the bag or the rig file is wrong.
        EstimatorError: The estimator raised.
    """
    rig = read_rig(request.rig)
    make_estimator = find_estimator(request.estimator)
    for setting in request.settings:
        if not is_of_estimator(setting):
            raise InputError(f"--set {setting}: a recording is as it was driven; wanted estimator.KEY=VALUE")
    make_configured = with_settings(request.estimator, make_estimator, request.settings)
    if not request.bag.exists():
        raise InputError(f"{request.bag}: no such recording; wanted a ROS 2 bag: its folder, or an MCAP file")
    name = recording_name(request.bag)
    out = request.out or RUNS / f"{name}-{request.estimator.replace(':', '.')}"
    with replacing_run_folder(out) as folder, keeping_traceback(out):
        digest = folder_digest(request.bag)
        made_by = provenance(make_estimator, request.bag)
        settings = settings_by_path(request.settings)
        header = RunHeader(name, digest, None, request.estimator, made_by, settings=settings)
        result = judge_recording(request.bag, rig, make_configured, header, folder, console)
    return replace(result, folder=out)


def recording_name(bag: Path) -> str:
    """Name a recording by its path; one that is merely called ``bag`` gets the name of its folder in front.

    Else the results of all recordings called so would take each other's place.
    """
    path = bag.absolute().parent.resolve() / bag.absolute().name
    name = path.name
    while re.fullmatch(r"bag(_\d+)?", path.stem) and path.parent.name:
        path = path.parent
        name = f"{path.name}-{name}"
    return name
