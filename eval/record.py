"""Write the recording of a scenario, and the nominal rig beside it, to a place of the user's choice."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from estimator.errors import InputError
from estimator.rig_file import write_rig
from eval.console import Console
from eval.out_folder import creating
from eval.video import write_video
from scenarios.load import load_scenario
from scenarios.recordings import cached_recording


@dataclass(frozen=True)
class RecordRequest:
    """What the user asks for: a scenario, a seed, settings on top, a place for the bag and one for a film."""

    scenario: str
    seed: int
    settings: tuple[str, ...]
    out: Path
    video: Path | None = None


def record_to(request: RecordRequest, console: Console) -> Path:
    """Write the bag, and the film if one is wanted, and return the rig file, ``<out>.rig.yaml``.

    The drive is rendered into the cache and copied from there, so a later ``run`` does not render it again.

    Raises:
        InputError: The scenario is wrong, or something is at one of the places already.
    """
    scenario = load_scenario(request.scenario, request.settings, request.seed)
    rig_file = request.out.with_name(f"{request.out.name}.rig.yaml")
    with creating(request.out) as bag, _creating_film(request.video) as film, creating(rig_file) as rig:
        with cached_recording(
            scenario, request.seed, lambda done, total: console.progress("rendering", done, total)
        ) as cached:
            _copy(cached, bag)
        if film is not None:
            title = f"{scenario.name}, seed {request.seed}"
            write_video(bag, scenario.rig, scenario.world.drive.rate_hz, film, title, console)
        write_rig(scenario.rig, rig)
    return rig_file


def _copy(cached: Path, bag: Path) -> None:
    """Copy a bag file by file: an error of ``copytree`` says nothing of full disks."""
    bag.mkdir()
    for file in cached.iterdir():
        shutil.copyfile(file, bag / file.name)


@contextmanager
def _creating_film(video: Path | None) -> Iterator[Path | None]:
    if video is None:
        yield None
        return
    if video.suffix.lower() != ".mp4":
        raise InputError(f"{video}: wanted a name that ends in .mp4")
    with creating(video) as film:
        yield film
