"""Load a scenario: find its file, resolve ``base``, lay ``--set`` on top, check every key."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from estimator.config_error import describe_first_error
from estimator.errors import InputError
from estimator.rig import Rig
from estimator.rig_file import read_rig
from scenarios.bundled import find_file
from scenarios.files import read_mapping
from scenarios.overrides import merge, parse_overrides
from scenarios.scenario import Scenario, ScenarioEntry
from sim.drive_end import check_times
from sim.faults.chain import check_cameras
from sim.faults.wrong_intrinsics import check_true_lenses
from sim.sensing.refit import check_lenses, with_lenses
from sim.vehicle.mount_events import check_events
from sim.vehicle.mounting_place import check_places
from sim.world import WorldConfig


@dataclass(frozen=True)
class Layer:
    """Keys from one source; a scenario is a stack of them, the topmost first."""

    source: str
    folder: Path
    keys: Mapping[str, Any]


def load_scenario(reference: str, settings: Iterable[str] = (), seed: int | None = None) -> Scenario:
    """Load a bundled scenario by name or a user's own by path.

    Args:
        reference: A bundled name, or a path relative to the working folder.
        settings: ``dotted.path=value`` texts that override the file.
        seed: What is known of a drive only with its seed is checked too: when it ends.

    Raises:
        InputError: One line with the file, the path of the key, what was got, wanted, and what there is.
    """
    path = find_file("scenario", reference, Path.cwd())
    overrides = Layer("--set", Path.cwd(), parse_overrides(settings))
    if "base" in overrides.keys:
        raise InputError("--set base: a base is chosen in the file, not on the command line")
    layers = (overrides, *_read_layers(path))
    entry = _validate(layers)
    rig_folder = next((layer.folder for layer in layers if "rig" in layer.keys), Path.cwd())
    rig_file = find_file("rig", entry.rig, rig_folder)
    rig, world = read_rig(rig_file), entry.world()
    if world.sensor.lens != "nominal":
        rig = with_lenses(rig, world.sensor.lens)
    try:
        check_lenses(rig)
        check_places(rig)
    except InputError as error:
        raise InputError(f"{rig_file}: {error}") from None
    _check_world(world, rig, seed, layers)
    return Scenario(path.stem, entry.about, rig, world)


def _check_world(world: WorldConfig, rig: Rig, seed: int | None, layers: Sequence[Layer]) -> None:
    """Refuse what the rig or the drive cannot do, before anything is built."""
    try:
        check_cameras(world.faults, rig.cameras)
        check_true_lenses(rig, world.faults)
        check_events(world.miscalibration.events, rig)
        if seed is not None:
            check_times(world, seed)
    except InputError as error:
        raise InputError(f"{_source_of(str(error).partition(':')[0], layers)}: {error}") from None


def _read_layers(path: Path) -> tuple[Layer, ...]:
    """Read a file and its bases, the most special first."""
    layers: list[Layer] = []
    visited: list[Path] = []
    while True:
        visited.append(path.resolve())
        keys = read_mapping(path, "scenario")
        base = keys.pop("base", None)
        layers.append(Layer(str(path), path.parent, keys))
        if base is None:
            return tuple(layers)
        if not isinstance(base, str):
            raise InputError(f"{path}: base: got {base!r}, wanted the name or file of a scenario")
        path = _find_base(path, base)
        if path.resolve() in visited:
            names = " -> ".join(each.stem for each in [*visited, path])
            raise InputError(f"{path}: base: scenarios inherit in a circle: {names}")


def _find_base(path: Path, base: str) -> Path:
    try:
        return find_file("scenario", base, path.parent)
    except InputError as error:
        raise InputError(f"{path}: base: {error}") from None


def _validate(layers: Sequence[Layer]) -> ScenarioEntry:
    merged: dict[str, Any] = {}
    for layer in reversed(layers):
        merged = merge(merged, layer.keys)
    try:
        return ScenarioEntry.model_validate(merged, strict=True)
    except ValidationError as error:
        problem = describe_first_error(error, ScenarioEntry).removeprefix("the file: ")
        key = problem.partition(":")[0]
        raise InputError(f"{_source_of(key, layers)}: {problem}") from None


def _source_of(key: str, layers: Sequence[Layer]) -> str:
    """Name the topmost layer that sets a dotted key; a key that nobody set is the file's to give."""
    parts = [part.partition("[")[0] for part in key.split(".")]
    for layer in layers:
        value: Any = layer.keys
        for part in parts:
            if not isinstance(value, Mapping) or part not in value:
                break
            value = value[part]
            if isinstance(value, list):  # what is in a list comes from whoever gave the list
                return layer.source
        else:
            return layer.source
    return layers[1].source
