"""``rigtrue list``: what scenarios, sweeps, rigs, estimators and metrics there are."""

from __future__ import annotations

import os
from collections.abc import Sequence
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from eval.options import Quiet

Table = tuple[Sequence[str], Sequence[Sequence[str]]]


class Topic(StrEnum):
    """What can be listed."""

    SCENARIOS = "scenarios"
    SWEEPS = "sweeps"
    RIGS = "rigs"
    ESTIMATORS = "estimators"
    METRICS = "metrics"


def list_command(
    topic: Annotated[Topic, typer.Argument(help="What to list.")],
    contact_sheet: Annotated[
        Path | None, typer.Option(metavar="FILE.png", help="Also draw thumbnails of all scenarios.")
    ] = None,
    quiet: Quiet = False,
) -> None:
    """List the bundled scenarios, sweeps or rigs, the installed estimators, or every metric."""
    from estimator.errors import InputError
    from eval.print_table import print_table

    if contact_sheet is not None and topic is not Topic.SCENARIOS:
        raise InputError(f"--contact-sheet: got {topic.value} to list, wanted scenarios")
    if contact_sheet is not None:
        _draw(contact_sheet, quiet)
    columns, rows = {
        Topic.SCENARIOS: _scenarios,
        Topic.SWEEPS: _sweeps,
        Topic.RIGS: _rigs,
        Topic.ESTIMATORS: _estimators,
        Topic.METRICS: _metrics,
    }[topic]()
    if not quiet:
        print_table(columns, rows)
        if contact_sheet is not None:
            print(f"contact sheet: {contact_sheet}")


def _draw(file: Path, quiet: bool) -> None:
    from eval.console import open_console
    from eval.contact_sheet import write_contact_sheet
    from scenarios.bundled import bundled_names

    with open_console(quiet=quiet, verbose=False) as console:
        write_contact_sheet(bundled_names("scenario"), file, os.cpu_count() or 1, console)


def _scenarios() -> Table:
    from scenarios.bundled import bundled_names, bundled_path
    from scenarios.files import read_mapping

    names = bundled_names("scenario")
    files = {name: read_mapping(bundled_path("scenario", name), "scenario") for name in names}
    return ("scenario", "about"), [(name, str(keys.get("about", ""))) for name, keys in files.items()]


def _sweeps() -> Table:
    from scenarios.bundled import bundled_names
    from scenarios.sweep import load_sweep

    sweeps = [load_sweep(name) for name in bundled_names("sweep")]
    return ("sweep", "runs", "about"), [(each.name, str(len(each.runs)), each.about) for each in sweeps]


def _rigs() -> Table:
    from estimator.rig_file import read_rig
    from scenarios.bundled import bundled_names, bundled_path

    rigs = {name: read_rig(bundled_path("rig", name)) for name in bundled_names("rig")}
    return ("rig", "cameras"), [(name, rig.names_text) for name, rig in rigs.items()]


def _estimators() -> Table:
    from eval.estimators import installed_estimators

    return ("estimator", "is"), [(name, entry.value) for name, entry in installed_estimators().items()]


def _metrics() -> Table:
    from eval.metric_keys import key_patterns

    rows = [(entry.key, entry.unit, entry.better, entry.meaning) for entry in key_patterns()]
    return ("key", "unit", "better", "means"), rows
