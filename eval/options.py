"""Options that several commands share, said once."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

ScenarioName = Annotated[str, typer.Argument(metavar="SCENARIO", help="A bundled name or a YAML file.")]
Seed = Annotated[int, typer.Option(min=0, help="Picks the street, the miscalibration and the noise.")]
EstimatorName = Annotated[
    str, typer.Option("--estimator", metavar="NAME", help="An installed name or module:Class.")
]
Settings = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="KEY=VALUE",
        help="Override a key of the scenario (drive.speed_mps=8) or estimator (estimator.refine=intrinsics).",
    ),
]
EstimatorSettings = Annotated[
    list[str] | None,
    typer.Option(
        "--set", metavar="KEY=VALUE", help="Override a setting, such as estimator.refine=intrinsics."
    ),
]
Out = Annotated[
    Path | None,
    typer.Option(metavar="DIR", help="Run folder; default reports/runs/<name>-<seed>-<estimator>."),
]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")]
Verbose = Annotated[bool, typer.Option("--verbose", "-v", help="Say more about what is done.")]
