"""Find bundled scenarios, sweeps and rigs by name, or a user's own by path."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from estimator.did_you_mean import did_you_mean
from estimator.errors import InputError

Kind = Literal["scenario", "sweep", "rig"]

_ROOM = Path(__file__).parent
_FOLDERS: dict[Kind, Path] = {"scenario": _ROOM, "sweep": _ROOM / "sweeps", "rig": _ROOM / "rigs"}
_SUFFIXES = (".yaml", ".yml")


def bundled_names(kind: Kind) -> tuple[str, ...]:
    """Return the names of what comes with the package, sorted."""
    return tuple(sorted(path.stem for path in _FOLDERS[kind].glob("*.yaml")))


def bundled_path(kind: Kind, name: str) -> Path:
    """Return the file of a bundled name."""
    return _FOLDERS[kind] / f"{name}.yaml"


def find_file(kind: Kind, reference: str, relative_to: Path) -> Path:
    """Return the file that a bundled name or a path means.

    Args:
        kind: What is sought.
        reference: A bundled name ("gap"), or a path: anything with a slash or the suffix of a YAML file.
        relative_to: Folder that a relative path starts from.

    Raises:
        InputError: Neither a bundled name nor a file.
    """
    if "/" in reference or reference.endswith(_SUFFIXES):
        path = relative_to / Path(reference).expanduser()
        if not path.is_file():
            raise InputError(f"{path}: no such {kind} file")
        return path
    names = bundled_names(kind)
    if reference not in names:
        beside = [
            f"./{reference}{suffix}"
            for suffix in _SUFFIXES
            if (relative_to / f"{reference}{suffix}").is_file()
        ]
        hint = f" (did you mean the file {beside[0]}?)" if beside else did_you_mean(reference, names)
        raise InputError(f"{kind} {reference!r} is not known{hint}; there are: {', '.join(names)}")
    return bundled_path(kind, reference)
