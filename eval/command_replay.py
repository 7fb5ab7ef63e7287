"""``rigtrue replay``: estimate on a recording, the user's own too; scores if the bag holds truth."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from eval.options import EstimatorName, EstimatorSettings, Out, Quiet, Verbose


def replay_command(
    bag: Annotated[Path, typer.Argument(metavar="BAG", help="Folder of a ROS 2 bag, or an MCAP file.")],
    rig: Annotated[Path, typer.Option(metavar="RIG.yaml", help="The nominal rig that recorded it.")],
    estimator: EstimatorName = "online",
    out: Out = None,
    settings: EstimatorSettings = None,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> None:
    """Estimate the rig from a recording; score it if the bag holds truth."""
    from eval.judged import judged
    from eval.replay import ReplayRequest, replay

    request = ReplayRequest(bag, rig, estimator, out, tuple(settings or ()))
    judged(lambda console: replay(request, console), quiet=quiet, verbose=verbose)
