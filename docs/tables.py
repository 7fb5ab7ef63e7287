"""The tables of the documentation that follow from the code: ``python -m docs.tables`` writes them anew."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any, get_args

from estimator.config_range import range_of
from scenarios.bundled import bundled_names
from scenarios.load import load_scenario
from scenarios.sweep import load_sweep
from sim.faults.fault import Fault
from sim.faults.kinds import WAY

DOCS = Path(__file__).parent
_SHARED = {"kind", "camera", "at_s", "duration_s"}


def scenario_table() -> str:
    """Return every bundled scenario with its sentence."""
    rows = [(f"`{name}`", load_scenario(name).about) for name in bundled_names("scenario")]
    return _table(("scenario", "what it tests, and what it should do to an estimator"), rows)


def sweep_table() -> str:
    """Return every bundled sweep with its number of runs."""
    sweeps = [load_sweep(name) for name in bundled_names("sweep")]
    return _table(("sweep", "runs", "about"), [(f"`{s.name}`", str(len(s.runs)), s.about) for s in sweeps])


def fault_table() -> str:
    """Return every kind of fault in the order in which an image meets them, and its own keys."""
    rows = []
    for fault in WAY:
        kind = get_args(fault.model_fields["kind"].annotation)[0]
        meaning = (fault.__doc__ or "").split("\n\n")[0].replace("\n   ", "").replace("``", "`")
        rows.append((f"`{kind}`", meaning, "; ".join(_keys(fault)) or "none"))
    return _table(("kind", "what happens", "its own keys, their defaults and ranges"), rows)


def _keys(fault: type[Fault]) -> list[str]:
    own = {name: field for name, field in fault.model_fields.items() if name not in _SHARED}
    ranges = {name: range_of(field.metadata) for name, field in own.items()}
    return [
        f"`{name}` {_text(field.default)}{ranges[name] and f' ({ranges[name]})'}"
        for name, field in own.items()
    ]


def _text(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)


def _table(columns: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    lines = [columns, tuple("---" for _ in columns), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


TABLES = {
    "scenarios.md": {"scenarios": scenario_table, "sweeps": sweep_table},
    "faults.md": {"kinds": fault_table},
}


def with_tables(page: str, text: str) -> str:
    """Return a page's text with each table, between its two marks, as it should be.

    Raises:
        ValueError: A mark is not in the text exactly once.
    """
    for name, make in TABLES[page].items():
        marked = re.compile(rf"(<!-- {name} -->\n).*?(<!-- end -->)", re.DOTALL)
        text, found = marked.subn(lambda match, make=make: f"{match[1]}{make()}\n{match[2]}", text)
        if found != 1:
            raise ValueError(f"{page}: {found} tables marked {name!r}; wanted one")
    return text


if __name__ == "__main__":
    for page in TABLES:
        (DOCS / page).write_text(with_tables(page, (DOCS / page).read_text()))
