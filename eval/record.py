"""Write the recording of a scenario, and the nominal rig beside it, to a place of the user's choice."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from pathlib import Path

from estimator.errors import InputError
from estimator.rig_file import write_rig
from eval.console import Console
from eval.out_folder import creating
from scenarios.load import load_scenario
from scenarios.recordings import cached_recording


def record_to(out: Path, scenario_name: str, seed: int, settings: Sequence[str], console: Console) -> Path:
    """Write the bag to ``out`` and return the rig file, ``<out>.rig.yaml``.

    The drive is rendered into the cache and copied from there, so a later ``run`` does not render it again.

    Raises:
        InputError: The scenario is wrong, or something is at ``out`` already.
    """
    scenario = load_scenario(scenario_name, settings)
    rig_file = out.with_name(f"{out.name}.rig.yaml")
    if rig_file.exists():
        raise InputError(f"{rig_file}: exists; wanted a name that is free")
    with creating(out) as bag:
        with cached_recording(
            scenario, seed, lambda done, total: console.progress("rendering", done, total)
        ) as cached:
            shutil.copytree(cached, bag)
        write_rig(scenario.rig, rig_file)
    return rig_file
