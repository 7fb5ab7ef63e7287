"""``rigtrue record``: simulate only, and leave a ROS 2 bag with truth."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from eval.options import Quiet, ScenarioName, Seed, Settings, Verbose


def record_command(
    scenario: ScenarioName,
    out: Annotated[Path, typer.Option(metavar="BAG", help="Folder of the bag; must not exist.")],
    seed: Seed = 0,
    settings: Settings = None,
    video: Annotated[
        Path | None, typer.Option(metavar="FILE.mp4", help="Also film all cameras side by side, for people.")
    ] = None,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> None:
    """Simulate a drive and write a ROS 2 bag with images and truth, and the rig file beside it."""
    from eval.console import open_console
    from eval.record import RecordRequest, record_to

    with open_console(quiet=quiet, verbose=verbose) as console:
        rig_file = record_to(RecordRequest(scenario, seed, tuple(settings or ()), out, video), console)
    if not quiet:
        print(f"recording: {out}")
        if video is not None:
            print(f"film: {video}")
        print(f"play it: rigtrue replay {out} --rig {rig_file}")
