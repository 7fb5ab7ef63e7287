"""What each fault does to the own estimator: every scenario's faults laid over one and the same recording.

``python -m tests.benchmark.fault_effects [SCENARIO ...]`` renders ``first_drive`` once (or takes it from the
cache), spoils its frames as each scenario says, estimates, and prints the worst camera among those that are
not struck and among those that are; ``first_drive`` itself is the drive without faults. Scenarios that change
how pictures are taken must be run themselves.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from estimator.bag import Bag
from estimator.bag_rosbags import parse
from estimator.errors import InputError
from estimator.image_decode import decode_image
from estimator.rig import Rig
from estimator.rig_file import rig_to_yaml, write_rig
from eval.console import QuietConsole
from eval.findings import finding_line
from eval.replay import ReplayRequest, replay
from eval.truth import read_truth
from scenarios.bundled import bundled_names
from scenarios.load import load_scenario
from scenarios.recordings import cached_recording
from scenarios.scenario import Scenario
from sim.bag_writer import BagWriter
from sim.faults.chain import FaultChain
from sim.faults.clock_faults import ClockOffset
from sim.faults.wrong_intrinsics import WrongIntrinsics
from sim.frame import Frame
from sim.world import Snapshot, Truth

BASE = "first_drive"


def snapshots(bag: Path, rig: Rig) -> Iterator[Snapshot]:
    """Yield a sound recording as it was written."""
    truth = read_truth(bag)
    assert truth is not None
    poses = dict(zip(truth.stamps_ns, truth.world_from_ego, strict=True))
    topics = {f"/{name}/image_raw": name for name in rig.cameras}
    frames: list[Frame] = []
    with Bag(bag) as source:
        for message in source.messages([*topics, "/truth/odometry"]):
            stamp_ns = message.header_stamp_ns
            if message.topic in topics:
                image = decode_image(parse(message))
                frames.append(Frame(topics[message.topic], stamp_ns, stamp_ns, image))
                continue
            at = Truth(stamp_ns, poses[stamp_ns], np.zeros(6), truth.ego_from_cams_at(stamp_ns))
            yield Snapshot(at, tuple(frames))
            frames = []


def spoil(sound: Path, scenario: Scenario, bag: Path) -> None:
    """Write the recording again with a scenario's faults in it."""
    chain = FaultChain(scenario.world.faults, scenario.rig.cameras, 0)
    with BagWriter(bag, scenario.rig) as writer:
        for index, snapshot in enumerate(snapshots(sound, scenario.rig)):
            time_s = scenario.world.drive.time_s(index)
            frames = chain.pass_on(snapshot.frames, index, time_s)
            writer.write(Snapshot(snapshot.truth, frames, chain.lasting(time_s)))


def effect(sound: Path, scenario: Scenario, folder: Path) -> str:
    """Estimate on a spoilt recording and say in one line what came of it."""
    spoil(sound, scenario, folder / "bag")
    write_rig(scenario.rig, folder / "rig.yaml")
    request = ReplayRequest(folder / "bag", folder / "rig.yaml", "online", folder / "run")
    try:
        result = replay(request, QuietConsole())
    except InputError as error:
        return f"refused: {str(error).replace(str(folder), '')}"
    metrics = json.loads((folder / "run" / "scores.json").read_text())["metrics"]

    def worst(names: list[str], quantity: str) -> float:
        return max((metrics[f"extrinsics.{name}.{quantity}"]["value"] for name in names), default=0.0)

    struck = [
        name
        for name in scenario.rig.estimated_names
        if any(fault.concerns(name) for fault in scenario.world.faults)
    ]
    others = [name for name in scenario.rig.estimated_names if name not in struck]
    states = ", ".join(f"{name} {result.final.cameras[name].status}" for name in struck)
    found = "; ".join(finding_line(finding) for finding in result.final.findings) or "no finding"
    return (
        f"others {worst(others, 'rotation_deg'):.3f} deg {worst(others, 'translation_mm'):.1f} mm; "
        f"struck {worst(struck, 'rotation_deg'):.3f} deg {worst(struck, 'translation_mm'):.1f} mm; "
        f"path {1000 * metrics['motion.ate_m']['value']:.0f} mm; {states}; {found}"
    )


def is_laid_over(scenario: Scenario) -> bool:
    """Tell whether a scenario is the base but for faults that leave the taking of pictures alone."""
    base = load_scenario(BASE)
    same_world = scenario.world.model_copy(update={"faults": []}) == base.world
    same_rig = rig_to_yaml(scenario.rig) == rig_to_yaml(base.rig)
    return (
        same_world
        and same_rig
        and not any(isinstance(each, (ClockOffset, WrongIntrinsics)) for each in scenario.world.faults)
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenarios", nargs="*", default=list(bundled_names("scenario")))
    chosen = [load_scenario(name) for name in parser.parse_args().scenarios]
    with cached_recording(load_scenario(BASE), 0, lambda done, total: None) as sound:
        for scenario in filter(is_laid_over, chosen):
            with tempfile.TemporaryDirectory() as folder:
                print(f"{scenario.name:<20} {effect(sound, scenario, Path(folder))}", flush=True)


if __name__ == "__main__":
    main()
