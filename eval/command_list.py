"""``rigtrue list``: what scenarios, estimators and metrics there are."""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum
from typing import Annotated

import typer


class Topic(StrEnum):
    """What can be listed."""

    SCENARIOS = "scenarios"
    ESTIMATORS = "estimators"
    METRICS = "metrics"


def list_command(topic: Annotated[Topic, typer.Argument(help="What to list.")]) -> None:
    """List the bundled scenarios, the installed estimators, or every metric."""
    from eval.print_table import print_table

    columns, rows = {
        Topic.SCENARIOS: _scenarios,
        Topic.ESTIMATORS: _estimators,
        Topic.METRICS: _metrics,
    }[topic]()
    print_table(columns, rows)


def _scenarios() -> tuple[Sequence[str], Sequence[Sequence[str]]]:
    from scenarios.bundled import bundled_names, bundled_path
    from scenarios.files import read_mapping

    names = bundled_names("scenario")
    files = {name: read_mapping(bundled_path("scenario", name), "scenario") for name in names}
    return ("scenario", "about"), [(name, str(keys.get("about", ""))) for name, keys in files.items()]


def _estimators() -> tuple[Sequence[str], Sequence[Sequence[str]]]:
    from eval.estimators import installed_estimators

    return ("estimator", "is"), [(name, entry.value) for name, entry in installed_estimators().items()]


def _metrics() -> tuple[Sequence[str], Sequence[Sequence[str]]]:
    from eval.metric_keys import key_patterns

    rows = [(entry.key, entry.unit, entry.better, entry.meaning) for entry in key_patterns()]
    return ("key", "unit", "better", "means"), rows
