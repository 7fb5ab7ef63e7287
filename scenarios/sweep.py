"""A sweep: scenarios x seeds x estimators, as a YAML file and as the list of its runs."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Annotated, Any

from pydantic import Field, ValidationError

from estimator.config import Config
from estimator.config_error import describe_first_error
from estimator.errors import InputError
from scenarios.bundled import bundled_path, find_file
from scenarios.files import read_mapping

Name = Annotated[str, Field(min_length=1)]
SeedNumber = Annotated[int, Field(ge=0)]


class SweepEntry(Config):
    """The keys of a sweep file."""

    about: Name
    scenarios: list[Name] = Field(min_length=1)
    seeds: list[SeedNumber] = Field(min_length=1)
    estimators: list[Name] = Field(["online"], min_length=1)


@dataclass(frozen=True)
class SweepRun:
    """One run of a sweep. ``scenario`` is a bundled name or the absolute path of a file."""

    scenario: str
    seed: int
    estimator: str


@dataclass(frozen=True)
class Sweep:
    """A loaded sweep: its name from the file, and its runs in order, none twice."""

    name: str
    about: str
    runs: tuple[SweepRun, ...]

    def expanded(self) -> dict[str, Any]:
        """Return what ``sweep.yaml`` of a result holds: every run spelt out."""
        runs = [{"scenario": run.scenario, "seed": run.seed, "estimator": run.estimator} for run in self.runs]
        return {"name": self.name, "about": self.about, "runs": runs}


def load_sweep(reference: str) -> Sweep:
    """Load a bundled sweep by name or a user's own by path; its scenarios are looked up from its folder.

    Raises:
        InputError: One line with the file, the key, what was got and what was wanted.
    """
    path = find_file("sweep", reference, Path.cwd())
    try:
        entry = SweepEntry.model_validate(read_mapping(path, "sweep"), strict=True)
    except ValidationError as error:
        raise InputError(f"{path}: {describe_first_error(error, SweepEntry)}") from None
    scenarios = [_absolute(path, name) for name in entry.scenarios]
    runs = dict.fromkeys(SweepRun(*each) for each in product(scenarios, entry.seeds, entry.estimators))
    _check_names(path, scenarios)
    return Sweep(path.stem, entry.about, tuple(runs))


def _check_names(sweep: Path, scenarios: list[str]) -> None:
    """Refuse two scenarios of one name: their run folders would have one name too."""
    names = Counter(Path(scenario).stem for scenario in dict.fromkeys(scenarios))
    twice = [name for name, count in names.items() if count > 1]
    if twice:
        raise InputError(f"{sweep}: scenarios: two are called {twice[0]!r}; wanted names that differ")


def _absolute(sweep: Path, scenario: str) -> str:
    """Check that a scenario exists; return a bundled name as it is, a file as an absolute path."""
    try:
        found = find_file("scenario", scenario, sweep.parent)
    except InputError as error:
        raise InputError(f"{sweep}: scenarios: {error}") from None
    return scenario if found == bundled_path("scenario", scenario) else str(found.resolve())
