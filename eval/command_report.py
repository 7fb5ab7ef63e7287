"""``rigtrue report``: build the HTML report of a run folder again."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer


def report_command(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="A run folder: it holds scores.json.")],
) -> None:
    """Build report.html of a run folder again from what the folder holds."""
    from estimator.errors import InputError
    from eval.report import rewrite_report

    if not (folder / "scores.json").is_file():
        raise InputError(f"{folder}: is no run folder, wanted one that holds scores.json")
    print(f"report: {rewrite_report(folder)}")
