"""Make ``report.html``, one file that needs no network, from what is in a run folder."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import jinja2
import plotly.graph_objects as go
from plotly.offline import get_plotlyjs

from estimator.errors import InputError
from eval.metric_keys import keys_for
from eval.plots_errors import error_figures
from eval.plots_map import apart_figure, path_figure, rig_figure
from eval.plots_style import CYCLE, figure_json
from eval.plots_time import stage_figure
from eval.report_tables import metric_groups, stage_rows
from eval.scale import share_text
from eval.verdict import verdict

REPORT = "report.html"
_OF_FOREIGN_FILES = (LookupError, TypeError, ValueError, ArithmeticError, AttributeError)


def write_report(folder: Path) -> Path:
    """Write the report of a run folder again and return its path.

    Raises:
        InputError: The folder is not that of a run.
    """
    scores, data = _read(folder, "scores.json"), _read(folder, "report_data.json")
    path = folder / REPORT
    try:
        path.write_text(render(scores, data), encoding="utf-8", newline="\n")
    except OSError as error:
        raise InputError(f"cannot write {path}: {error.strerror}") from error
    return path


def rewrite_report(folder: Path) -> Path:
    """Write the report of a folder that may have been written by anybody.

    Raises:
        InputError: The folder is not that of a run, or its files are not those that a run writes.
    """
    try:
        return write_report(folder)
    except (*_OF_FOREIGN_FILES, jinja2.TemplateError) as error:
        reason = " ".join(f"{type(error).__name__}: {error}".split())
        raise InputError(
            f"{folder}: scores.json and report_data.json are not as a run writes them ({reason})"
        ) from None


def render(scores: Mapping[str, Any], data: Mapping[str, Any]) -> str:
    """Return the page."""
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("eval", "."),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    cameras = [name for name in data["cameras"] if name != data["reference"]]
    return environment.get_template("report.html.j2").render(
        scores=scores,
        data=data,
        verdict=verdict(data, scores["metrics"]),
        figures={name: figure_json(figure) for name, figure in _figures(data).items()},
        metric_groups=metric_groups(scores["metrics"], keys_for(cameras)),
        stages=stage_rows(data),
        share_text=share_text,
        colours=CYCLE,
        plotly_js=get_plotlyjs(),
    )


def _figures(data: Mapping[str, Any]) -> dict[str, go.Figure]:
    """Return the figures by the id of their place on the page."""
    figures = {"rig": rig_figure(data)}
    if data["paths"]["estimated"]["x_m"] or data["paths"]["true"]:
        figures["path"] = path_figure(data)
    if "apart_m" in data["paths"]:
        figures["apart"] = apart_figure(data["paths"])
    if data["stages"]["stages"]:
        figures["stages"] = stage_figure(data["stages"])
    errors = error_figures(data["series"]).values()
    return figures | {f"error-{index}": figure for index, figure in enumerate(errors)}


def _read(folder: Path, name: str) -> dict[str, Any]:
    try:
        content = json.loads((folder / name).read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise InputError(f"{folder} is not the folder of a run: it holds no {name}") from None
    except (OSError, ValueError) as error:
        raise InputError(f"cannot read {folder / name}: {error}") from None
    if not isinstance(content, dict):
        raise InputError(f"{folder / name}: got a {type(content).__name__}, wanted an object")
    return content
