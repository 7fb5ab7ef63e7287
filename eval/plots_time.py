"""Where the time of each update went."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import plotly.graph_objects as go

from eval.plots_style import CYCLE, label, styled

_MAX_STAGES = 8


def stage_figure(stages: Mapping[str, Any]) -> go.Figure:
    """Stack the mean milliseconds a bundle of each stage over the drive; small stages are joined."""
    figure = go.Figure()
    for (name, milliseconds), colour in zip(_largest(stages["stages"]), CYCLE, strict=False):
        figure.add_bar(x=stages["time_s"], y=milliseconds, name=label(name), marker={"color": colour})
        figure.data[-1].hovertemplate = "%{y:.1f} ms"
    figure.update_layout(barmode="stack", bargap=0.08)
    figure.update_xaxes(title_text="time of the drive (s)")
    figure.update_yaxes(title_text="per bundle (ms)", tickformat="d")
    return styled(figure, 320)


def _largest(stages: Mapping[str, Any]) -> list[tuple[str, list[float]]]:
    ordered = sorted(stages.items(), key=lambda item: -item[1]["updates_s"])
    shown = [(name, stage["ms"]) for name, stage in ordered[: _MAX_STAGES - 1]]
    rest = [stage["ms"] for _, stage in ordered[_MAX_STAGES - 1 :]]
    return [*shown, ("other", [sum(column) for column in zip(*rest, strict=True)])] if rest else shown
