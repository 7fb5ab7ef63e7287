"""The drive from above, the rig from above, and how far the two paths are apart."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import plotly.graph_objects as go

from estimator.se3 import Array
from eval.plots_style import LINE_OF, VERMILLION, faded, label, styled

_FAN_IN_MAP_SHARE = 0.07
_KINDS = ("nominal", "true", "estimated")


def path_figure(data: Mapping[str, Any]) -> go.Figure:
    """Draw both paths in world x and y, with the cameras' fans of view at four places."""
    figure = go.Figure()
    size_m = _fan_size_m(data["paths"])
    for kind in ("true", "estimated"):
        path = data["paths"][kind]
        if path is None or not path["x_m"]:
            continue
        figure.add_scatter(x=path["x_m"], y=path["y_m"], mode="lines", name=kind, line=LINE_OF[kind])
        fans = [_in_world(fan, place, size_m) for place in path["places"] for fan in _fans(data, kind)]
        _add_outlines(figure, fans, kind, legend=False)
    figure.update_xaxes(title_text="x (m)")
    figure.update_yaxes(title_text="y (m)", scaleanchor="x", scaleratio=1)
    return styled(figure, 460).update_layout(hovermode="closest")


def rig_figure(data: Mapping[str, Any]) -> go.Figure:
    """Draw the cameras in the ego frame, forward up the page: nominal, estimated, true."""
    figure = go.Figure()
    for kind in _KINDS:
        # Turned so that the car points up: page x is ego -y, page y is ego x.
        fans = [np.column_stack([-fan[:, 1], fan[:, 0]]) for fan in _fans(data, kind)]
        if fans:
            _add_outlines(figure, fans, kind, legend=True)
    for name, (x, y) in _label_places(data).items():
        figure.add_annotation(x=x, y=y, text=label(name), showarrow=False, bgcolor="rgba(255,255,255,0.8)")
    figure.update_xaxes(title_text="to the right, −y (m)")
    figure.update_yaxes(title_text="ahead, x (m)", scaleanchor="x", scaleratio=1)
    return styled(figure, 560).update_layout(hovermode=False)


def apart_figure(paths: Mapping[str, Any]) -> go.Figure:
    """Draw the distance between the paths over the distance driven."""
    figure = go.Figure()
    centimetres = [100 * value for value in paths["apart_m"]]
    line = {"color": VERMILLION, "width": 2}
    figure.add_scatter(x=paths["driven_m"], y=centimetres, mode="lines", line=line, fill="tozeroy")
    figure.update_traces(fillcolor=faded(VERMILLION, 0.12), hovertemplate="%{y:.2f} cm")
    figure.update_xaxes(title_text="distance driven (m)")
    figure.update_yaxes(title_text="paths apart (cm)", rangemode="tozero")
    return styled(figure, 220, legend=False)


def _label_places(data: Mapping[str, Any]) -> dict[str, tuple[float, float]]:
    """Return a place on the page for each camera's name, inside its fan, moved up where two would overlap."""
    places: dict[str, tuple[float, float]] = {}
    for name, camera in data["cameras"].items():
        apex, *arc = camera["poses"]["nominal"]["fan_m"]
        ahead, left = np.mean(arc, axis=0) * 0.75 + np.array(apex) * 0.25
        x, y = -float(left), float(ahead)
        while any(abs(x - other_x) < 1.1 and abs(y - other_y) < 0.24 for other_x, other_y in places.values()):
            y += 0.25
        places[name] = x, y
    return places


def _fans(data: Mapping[str, Any], kind: str) -> list[Array]:
    """Return the closed outlines of all cameras that have a pose of this kind."""
    poses = [camera["poses"].get(kind) for camera in data["cameras"].values()]
    outlines = [np.array(pose["fan_m"]) for pose in poses if pose is not None]
    return [np.vstack([outline, outline[:1]]) for outline in outlines]


def _in_world(fan: Array, place: list[float], size_m: float) -> Array:
    x, y, yaw = place
    turn = np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]])
    reached = fan[0] + size_m * (fan - fan[0])
    return np.asarray(reached @ turn.T + [x, y])


def _fan_size_m(paths: Mapping[str, Any]) -> float:
    shown = paths["true"] or paths["estimated"]
    spans = [max(axis) - min(axis) for axis in (shown["x_m"], shown["y_m"]) if axis]
    return max(1.0, _FAN_IN_MAP_SHARE * max(spans, default=1.0))


def _add_outlines(figure: go.Figure, outlines: list[Array], kind: str, *, legend: bool) -> None:
    """Add outlines as one trace, a gap between them."""
    gap = np.full((1, 2), np.nan)
    points = np.vstack([part for outline in outlines for part in (outline, gap)])
    x, y = ([None if np.isnan(value) else round(float(value), 4) for value in axis] for axis in points.T)
    figure.add_scatter(
        x=x, y=y, mode="lines", name=kind, line=LINE_OF[kind], hoverinfo="skip", showlegend=legend
    )
