"""The numbers of the report's tables, as text ready to print."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from eval.metric_keys import MetricKey

_WHOLE_RUN, _AT_DISTANCES = "Whole run", "Worst and median camera after set distances"


@dataclass(frozen=True)
class MetricRow:
    """One metric as shown; ``reason`` stands where there is no value."""

    key: str
    text: str
    unit: str
    better: str
    meaning: str
    reason: str | None


@dataclass(frozen=True)
class StageRow:
    """What one stage cost: wall seconds in all updates and in the final step, and its share."""

    name: str
    updates_s: float
    close_s: float
    ms_per_bundle: float
    share_percent: float


def metric_groups(
    metrics: Mapping[str, Mapping[str, Any]], keys: Sequence[MetricKey]
) -> list[tuple[str, list[MetricRow]]]:
    """Return the metrics by group: the whole run first, then each camera."""
    meanings = {entry.key: entry.meaning for entry in keys}
    groups: dict[str, list[MetricRow]] = {}
    for key, metric in metrics.items():
        row = MetricRow(
            key,
            number_text(metric["value"]),
            "" if metric["unit"] == "1" else metric["unit"],
            metric["better"],
            meanings.get(key, ""),
            metric.get("reason"),
        )
        groups.setdefault(_group(key), []).append(row)
    return sorted(groups.items(), key=lambda item: (item[0] != _WHOLE_RUN, item[0] != _AT_DISTANCES))


def number_text(value: float | None) -> str:
    """Write a number with 4 significant digits and no exponent where a person can read it without."""
    if value is None:
        return "—"
    if value == int(value) and abs(value) < 1e6:
        return str(int(value))
    return f"{value:.4g}" if abs(value) < 1e4 else f"{value:.0f}"


def stage_rows(data: Mapping[str, Any]) -> list[StageRow]:
    """Return the stages, the costliest first."""
    stages, count = data["stages"]["stages"], data["bundle_count"]
    total_s = sum(stage["updates_s"] + stage["close_s"] for stage in stages.values()) or 1.0
    rows = [
        StageRow(
            name,
            stage["updates_s"],
            stage["close_s"],
            1000 * stage["updates_s"] / count,
            100 * (stage["updates_s"] + stage["close_s"]) / total_s,
        )
        for name, stage in stages.items()
    ]
    return sorted(rows, key=lambda row: -row.share_percent)


def _group(key: str) -> str:
    family, _, rest = key.partition(".")
    camera = rest.partition(".")[0]
    if family != "extrinsics":
        return _WHOLE_RUN
    if camera not in ("worst", "median"):
        return f"Camera {camera}"
    return _AT_DISTANCES if ".at_" in rest else _WHOLE_RUN
