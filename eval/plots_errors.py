"""Each camera's error, or its distance from the nominal pose, over the drive, with its stated uncertainty."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import plotly.graph_objects as go
from plotly.subplots import make_subplots

from eval.plots_style import BLUE, GREEN, VERMILLION, faded, styled

_ROWS = (
    ("rotation_deg", "rotation95_deg", "rotation (deg)"),
    ("translation_mm", "translation95_mm", "position (mm)"),
)
_LOWEST = {"rotation_deg": 1e-3, "translation_mm": 0.1}


def error_figures(series: Mapping[str, Any]) -> dict[str, go.Figure]:
    """Return one figure a camera; all share their ranges, so they can be compared by eye."""
    ranges = {key: _log_range(series["cameras"], key, stated) for key, stated, _ in _ROWS}
    return {name: _camera_figure(curves, series, ranges) for name, curves in series["cameras"].items()}


def _camera_figure(
    curves: Mapping[str, Any], series: Mapping[str, Any], ranges: Mapping[str, tuple[float, float]]
) -> go.Figure:
    x, x_title = x_axis(series)
    figure = make_subplots(rows=2, cols=1, shared_xaxes=True, vertical_spacing=0.07)
    name = "distance from nominal" if series["against"] == "nominal" else "true error"
    for row, (key, stated, title) in enumerate(_ROWS, start=1):
        decades = ranges[key]
        for trace in _traces(x, curves[key], curves[stated], 10 ** decades[0], name):
            figure.add_trace(trace, row=row, col=1)
        figure.update_yaxes(type="log", title_text=title, range=decades, dtick=1, row=row, col=1)
    figure.update_xaxes(title_text=x_title, row=2, col=1)
    if curves["converged_index"] is not None:
        at = x[curves["converged_index"]]
        figure.add_vline(x=at, line={"color": GREEN, "width": 1.5, "dash": "dot"})
    return styled(figure, 310, legend=False)


def x_axis(series: Mapping[str, Any]) -> tuple[Sequence[float], str]:
    """Return the distance driven where it is known, else the time."""
    if series["driven_m"] is not None:
        return series["driven_m"], "distance driven (m)"
    return series["time_s"], "time (s)"


def _traces(
    x: Sequence[float], values: Sequence[Any], stated: Sequence[Any], floor: float, name: str
) -> list[go.Scatter]:
    # Steps, for an online estimate holds until the next one. The band is drawn from the floor of the axis:
    # zero has no place on a log axis.
    edge = [None if value is None else max(value, floor) for value in stated]
    shown = [None if value is None else max(value, floor) for value in values]
    common = {"x": list(x), "mode": "lines"}
    return [
        go.Scatter(**common, y=[floor] * len(x), line={"width": 0}, hoverinfo="skip"),
        go.Scatter(
            **common,
            y=edge,
            name="stated 95 %",
            line={"color": BLUE, "width": 1, "shape": "hv"},
            fill="tonexty",
            fillcolor=faded(BLUE, 0.16),
            hovertemplate="%{y:.3g}",
        ),
        go.Scatter(
            **common,
            y=shown,
            name=name,
            line={"color": VERMILLION, "width": 2.2, "shape": "hv"},
            hovertemplate="%{y:.3g}",
        ),
    ]


def _log_range(cameras: Mapping[str, Any], key: str, stated: str) -> tuple[float, float]:
    values = [
        value for curves in cameras.values() for name in (key, stated) for value in curves[name] if value
    ]
    low = max(min(values, default=1.0), _LOWEST[key])
    high = max(max(values, default=10.0), 10 * low)
    return math.log10(low / 1.6), math.log10(high * 1.6)
