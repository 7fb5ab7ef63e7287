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
        path, equals, text = setting.partition("=")
        parts = path.strip().split(".")
        if not equals or not all(parts):
            raise InputError(f"--set {setting}: wanted KEY=VALUE, for example drive.speed_mps=8")
        nested: Any = parse_yaml(text, f"--set {setting}")
        for part in reversed(parts):
            nested = {part: nested}
        result = merge(result, nested)
    return result


def merge(lower: Mapping[str, Any], upper: Mapping[str, Any]) -> dict[str, Any]:
    """Lay ``upper`` over ``lower``: mappings merge key by key, anything else replaces."""
    result = dict(lower)
    for key, value in upper.items():
        below = result.get(key)
        both = isinstance(below, Mapping) and isinstance(value, Mapping)
        result[key] = merge(below, value) if both else value  # type: ignore[arg-type]
    return result
