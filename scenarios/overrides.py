"""Turn ``--set drive.speed_mps=8`` into the same nested keys that a scenario file has."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from estimator.errors import InputError
from estimator.yaml_file import parse_yaml


def parse_overrides(settings: Iterable[str]) -> dict[str, Any]:
    """Return nested keys from ``dotted.path=value`` texts; a value is YAML, a later text wins.

    Raises:
        InputError: No ``=``, an empty part in the path, or a value that is not YAML.
    """
    result: dict[str, Any] = {}
    for setting in settings:
        path, nested = _parse(setting)
        for part in reversed(path.split(".")):
            nested = {part: nested}
        result = merge(result, nested)
    return result


def settings_by_path(settings: Iterable[str]) -> dict[str, Any]:
    """Return the value of each dotted path as it was set, for the record of a run; a later text wins.

    Raises:
        InputError: As ``parse_overrides`` does.
    """
    return dict(map(_parse, settings))


def _parse(setting: str) -> tuple[str, Any]:
    path, equals, text = setting.partition("=")
    path = path.strip()
    if not equals or not all(path.split(".")):
        raise InputError(f"--set {setting}: wanted KEY=VALUE, for example drive.speed_mps=8")
    return path, parse_yaml(text, f"--set {setting}")


def merge(lower: Mapping[str, Any], upper: Mapping[str, Any]) -> dict[str, Any]:
    """Lay ``upper`` over ``lower``: mappings merge key by key, anything else replaces."""
    result = dict(lower)
    for key, value in upper.items():
        below = result.get(key)
        both = isinstance(below, Mapping) and isinstance(value, Mapping)
        result[key] = merge(below, value) if both else value  # type: ignore[arg-type]
    return result
