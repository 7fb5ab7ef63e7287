"""The first thing a reader sees: was the rig found, and may the answer be believed?"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from eval.metrics_convergence import ROTATION_LIMIT_DEG, TRANSLATION_LIMIT_MM

Tone = Literal["good", "bad", "neutral"]
_LIMITS = f"{ROTATION_LIMIT_DEG:g}° and {TRANSLATION_LIMIT_MM:g} mm"


@dataclass(frozen=True)
class Figure:
    """One large number: what it is, its text, and a line on what it belongs to."""

    label: str
    text: str
    note: str


@dataclass(frozen=True)
class Verdict:
    """A headline, its tone, one sentence, and the numbers behind it."""

    tone: Tone
    headline: str
    sentence: str
    figures: tuple[Figure, ...]


def verdict(data: Mapping[str, Any], metrics: Mapping[str, Mapping[str, Any]]) -> Verdict:
    """Judge the run against truth, or tell what the estimator claims where there is none."""
    cameras = {name: camera for name, camera in data["cameras"].items() if not camera["is_reference"]}
    figures: tuple[Figure, ...] = (
        *_worst(cameras, "error" if data["has_truth"] else "stated95"),
        _status(cameras),
    )
    if not data["has_truth"]:
        sentence = "The recording holds no truth, so the numbers are what the estimator itself states (95 %)."
        return Verdict("neutral", "The rig was estimated; nothing here can check it", sentence, figures)
    found = [name for name, camera in cameras.items() if _is_found(camera["error"])]
    honest = sum(camera["inside95"] is True for camera in cameras.values())
    figures = (
        *figures,
        _converged(metrics),
        Figure("Inside stated 95 %", f"{honest} of {len(cameras)}", "cameras"),
    )
    if len(found) == len(cameras):
        return Verdict("good", "Every camera was found", f"All are within {_LIMITS} of the truth.", figures)
    lost = ", ".join(name for name in cameras if name not in found)
    headline = f"{len(found)} of {len(cameras)} cameras were found"
    return Verdict("bad", headline, f"Not within {_LIMITS} of the truth: {lost}.", figures)


def _is_found(error: Mapping[str, float | None] | None) -> bool:
    if error is None or error["rotation_deg"] is None or error["translation_mm"] is None:
        return False
    return error["rotation_deg"] <= ROTATION_LIMIT_DEG and error["translation_mm"] <= TRANSLATION_LIMIT_MM


def _worst(cameras: Mapping[str, Any], kind: str) -> tuple[Figure, Figure]:
    prefix = "Worst" if kind == "error" else "Least sure"
    return (
        _worst_of(cameras, kind, "rotation_deg", f"{prefix} rotation", "°", 3),
        _worst_of(cameras, kind, "translation_mm", f"{prefix} position", " mm", 1),
    )


def _worst_of(
    cameras: Mapping[str, Any], kind: str, quantity: str, label: str, unit: str, decimals: int
) -> Figure:
    values = {name: camera[kind] and camera[kind][quantity] for name, camera in cameras.items()}
    unknown = next((name for name, value in values.items() if value is None), None)
    if unknown is not None or not values:
        return Figure(label, "unknown", f"camera {unknown}" if unknown else "no camera but the reference")
    name = max(values, key=lambda camera: values[camera])
    return Figure(label, f"{values[name]:.{decimals}f}{unit}", name)


def _status(cameras: Mapping[str, Any]) -> Figure:
    converged = sum(camera["status"] == "converged" for camera in cameras.values())
    others = sorted({str(camera["status"]) for camera in cameras.values()} - {"converged"})
    note = f"others: {', '.join(others)}" if others else "in the estimator's own view"
    return Figure("Says converged", f"{converged} of {len(cameras)}", note)


def _converged(metrics: Mapping[str, Mapping[str, Any]]) -> Figure:
    time, distance = metrics["convergence.time_s"], metrics["convergence.distance_m"]
    if time["value"] is None:
        return Figure("Found after", "not yet", f"all within {_LIMITS} and staying, before the final step")
    where = "" if distance["value"] is None else f", {distance['value']:.0f} m driven"
    return Figure("Found after", f"{time['value']:.1f} s", f"all within {_LIMITS}{where}")
