"""Read a YAML 1.2 file that a person wrote; whatever is wrong with it becomes one line."""

from __future__ import annotations

from pathlib import Path

from ruamel.yaml import YAML
from ruamel.yaml.constructor import DuplicateKeyError
from ruamel.yaml.error import MarkedYAMLError, YAMLError

from estimator.errors import InputError


def read_yaml(path: Path, what: str) -> object:
    """Return the plain values of a file.

    Args:
        path: The file.
        what: What it should be, for the message: "rig file".

    Raises:
        InputError: No such file, not readable, not text, not YAML, or a key given twice.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise InputError(f"{path}: no such {what}") from None
    except IsADirectoryError:
        raise InputError(f"{path}: got a folder, wanted a {what}") from None
    except UnicodeDecodeError:
        raise InputError(f"{path}: got a file that is not text, wanted a {what} in YAML") from None
    except OSError as error:
        raise InputError(f"{path}: cannot read this {what}: {error.strerror}") from None
    return parse_yaml(text, str(path))


def parse_yaml(text: str, source: str) -> object:
    """Return the plain values of a YAML text; ``source`` names it in errors."""
    try:
        return YAML(typ="safe", pure=True).load(text)
    except DuplicateKeyError as error:
        key = (error.problem or "").split('"')[1:2]
        raise InputError(f"{source}{_line(error)}: key {key[0] if key else '?'!r} is given twice") from None
    except MarkedYAMLError as error:
        problem = " ".join((error.problem or error.context or "malformed").split())
        raise InputError(f"{source}{_line(error)}: not valid YAML: {problem}") from None
    except (YAMLError, ValueError, RecursionError) as error:
        problem = " ".join(str(error).split()) or "nested too deeply"
        raise InputError(f"{source}: not valid YAML: {problem}") from None


def _line(error: MarkedYAMLError) -> str:
    mark = error.problem_mark or error.context_mark
    return f", line {mark.line + 1}" if mark is not None else ""
