"""Read a YAML file that must hold keys with values."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from estimator.errors import InputError
from estimator.yaml_file import read_yaml


def read_mapping(path: Path, what: str) -> dict[str, Any]:
    """Return the top-level keys of a scenario or sweep file.

    Raises:
        InputError: Not readable, not YAML, or something else than keys with values.
    """
    values = read_yaml(path, f"{what} file")
    if not isinstance(values, dict):
        got = "nothing" if values is None else type(values).__name__
        raise InputError(f"{path}: got {got}, wanted a {what}: keys with values")
    return values
