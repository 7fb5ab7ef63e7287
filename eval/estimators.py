"""Find an estimator: installed under the entry point ``rigtrue.estimators``, or any ``module:Class``."""

from __future__ import annotations

import importlib
import sys
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import Any, cast

from estimator.errors import InputError
from estimator.interface import EstimatorFactory

GROUP = "rigtrue.estimators"


def installed_estimators() -> dict[str, EntryPoint]:
    """Return the entry points by name, sorted."""
    return {entry.name: entry for entry in sorted(entry_points(group=GROUP), key=lambda entry: entry.name)}


def find_estimator(name: str) -> EstimatorFactory:
    """Return what constructs an estimator from the nominal rig.

    Args:
        name: An installed name, or ``module:Class``; the working folder is searched for the module too.

    Raises:
        InputError: Unknown, or its module cannot be imported.
    """
    installed = installed_estimators()
    if name not in installed and ":" not in name:
        there = ", ".join(installed) or "none"
        raise InputError(f"estimator {name!r} is not known; there are: {there}, or any module:Class")
    module, _, attribute = (installed[name].value if name in installed else name).partition(":")
    factory = _import(name, module, attribute)
    if not callable(factory):
        got = type(factory).__name__
        raise InputError(f"estimator {name!r}: got a {got}, wanted a class or function of the nominal rig")
    return cast(EstimatorFactory, factory)


def _import(name: str, module: str, attribute: str) -> Any:
    if str(Path.cwd()) not in sys.path:
        sys.path.append(str(Path.cwd()))
    try:
        return getattr(importlib.import_module(module), attribute)
    except (ImportError, SyntaxError, ValueError) as error:
        raise InputError(f"estimator {name!r}: cannot import {module!r}: {error}") from error
    except AttributeError:
        raise InputError(f"estimator {name!r}: module {module!r} has no {attribute!r}") from None
