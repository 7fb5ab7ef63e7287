"""``rigtrue run``: simulate, estimate, score, report."""

from __future__ import annotations

from eval.options import EstimatorName, Out, Quiet, ScenarioName, Seed, Settings, Verbose


def run_command(
    scenario: ScenarioName,
    seed: Seed = 0,
    estimator: EstimatorName = "online",
    out: Out = None,
    settings: Settings = None,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> None:
    """Simulate a drive, estimate the rig from its images, score it, write a report."""
    from eval.judged import judged
    from eval.run import RunRequest, run

    request = RunRequest(scenario, seed, estimator, tuple(settings or ()), out)
    judged(lambda console: run(request, console), quiet=quiet, verbose=verbose)
