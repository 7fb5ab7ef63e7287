"""One run of a sweep as a value that travels to a worker process."""

from __future__ import annotations

import json
import traceback
from dataclasses import dataclass
from pathlib import Path

from eval.code_digest import code_digest
from eval.console import QuietConsole
from eval.estimators import find_estimator
from eval.run import RunRequest, run, run_name
from scenarios.digest import recording_digest
from scenarios.load import load_scenario
from scenarios.sweep import SweepRun
from sim.fingerprint import fingerprint
from sim.rendering.choice import probe
from sim.rendering.names import RendererName


@dataclass(frozen=True)
class SweepJob:
    """A run with everything that decides its result.

    Attributes:
        request: What to run, and the run folder to write.
        name: Name of the scenario.
        cameras: The cameras that are estimated, for the rows of a run that failed.
        digest: Of the recording.
        renderer: What would draw it.
        code: Digest of the code that would make the result.
    """

    request: RunRequest
    name: str
    cameras: tuple[str, ...]
    digest: str
    renderer: RendererName
    code: str

    def is_finished(self) -> bool:
        """Tell whether the run folder holds this very run, made by this code and drawn by this machine.

        Where this machine cannot draw, by any machine.
        """
        assert self.request.out is not None
        try:
            scores = json.loads((self.request.out / "scores.json").read_text())
            made_by = scores["provenance"]["code"], scores["provenance"]["renderer"]
        except (OSError, ValueError, KeyError, TypeError):
            return False
        drawn_here = made_by[1] == fingerprint(self.renderer) or probe(self.renderer).problem is not None
        return bool(scores["digest"] == self.digest and made_by[0] == self.code and drawn_here)


def plan_job(planned: SweepRun, folder: Path) -> SweepJob:
    """Check one run of a sweep before anything is rendered.

    Raises:
        InputError: The scenario or the estimator is wrong.
    """
    scenario = load_scenario(planned.scenario, seed=planned.seed)
    name = run_name(scenario.name, planned.seed, planned.estimator)
    request = RunRequest(planned.scenario, planned.seed, planned.estimator, out=folder / name)
    code = code_digest(find_estimator(planned.estimator))
    digest = recording_digest(scenario, planned.seed)
    renderer = scenario.world.renderer
    return SweepJob(request, scenario.name, scenario.rig.estimated_names, digest, renderer, code)


def run_job(job: SweepJob) -> str | None:
    """Run one job to its run folder, unless it is there already; return why it failed, or None.

    Whatever goes wrong in one run must not stop the others, so any exception becomes a reason.
    """
    if job.is_finished():
        return None
    try:
        run(job.request, QuietConsole())
    except Exception as error:
        reason = " ".join(f"{type(error).__name__}: {error}".split())
        _keep_crash(job.request.out, error)
        return reason
    return None


def _keep_crash(out: Path | None, error: Exception) -> None:
    """Leave a traceback beside the run folder that is not there."""
    if out is not None:
        out.with_name(f"{out.name}.error.log").write_text("".join(traceback.format_exception(error)))
