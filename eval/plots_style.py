"""One look for every figure: a palette that colour-blind readers can tell apart, quiet axes, no tools bar."""

from __future__ import annotations

from html import escape
from typing import Any

import plotly.graph_objects as go

# Okabe & Ito 2008.
BLUE, VERMILLION, GREEN, ORANGE = "#0072B2", "#D55E00", "#009E73", "#E69F00"
SKY, PURPLE, YELLOW, GREY = "#56B4E9", "#CC79A7", "#F0E442", "#6B7280"
CYCLE = (BLUE, ORANGE, GREEN, PURPLE, SKY, VERMILLION, YELLOW, GREY)
_INK, _GRID = "#1f2933", "#e3e7ec"


def faded(colour: str, alpha: float) -> str:
    """Return a palette colour with transparency."""
    red, green, blue = (int(colour[start : start + 2], 16) for start in (1, 3, 5))
    return f"rgba({red},{green},{blue},{alpha})"


# The truth lies wide and pale under the thin estimate, so that both are seen where they agree.
LINE_OF: dict[str, dict[str, Any]] = {
    "true": {"color": faded(BLUE, 0.45), "width": 5},
    "estimated": {"color": VERMILLION, "width": 1.6},
    "nominal": {"color": GREY, "width": 1.6, "dash": "dot"},
}


def styled(figure: go.Figure, height_px: int, *, legend: bool = True) -> go.Figure:
    """Apply the common look; the width follows the page."""
    figure.update_layout(
        height=height_px,
        margin={"l": 62, "r": 12, "t": 28 if legend else 10, "b": 46},
        font={"family": "system-ui, sans-serif", "size": 13, "color": _INK},
        paper_bgcolor="white",
        plot_bgcolor="white",
        showlegend=legend,
        legend={"orientation": "h", "x": 0, "y": 1.0, "yanchor": "bottom"},
        hovermode="x unified",
        dragmode=False,
    )
    figure.update_xaxes(gridcolor=_GRID, zeroline=False, linecolor="#9aa5b1", ticks="outside")
    figure.update_yaxes(title_standoff=8, automargin=True)
    figure.update_yaxes(gridcolor=_GRID, zeroline=False, linecolor="#9aa5b1", ticks="outside")
    return figure


def label(text: str) -> str:
    """Make a name safe for plotly, which reads a few tags in its texts."""
    return escape(text, quote=False)


def figure_json(figure: go.Figure) -> dict[str, Any]:
    """Return a figure as JSON values, without plotly's 7 kB default template."""
    figure.update_layout(template="none")
    content: dict[str, Any] = figure.to_plotly_json()
    content["layout"].pop("template", None)
    return content
