"""Drive an estimator over a recording. It sees the nominal rig when made, then bundles, and nothing else."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from estimator.errors import InputError
from estimator.estimate import Estimate
from estimator.interface import EstimatorFactory
from estimator.recording import Recording
from estimator.rig import Rig
from eval.collect import RunLog

OnBundle = Callable[[int, int], None]


class EstimatorError(Exception):
    """An estimator raised, or answered with something that is no estimate; the cause is chained."""


def estimate_recording(
    recording: Recording, make_estimator: EstimatorFactory, log: RunLog, on_bundle: OnBundle
) -> None:
    """Feed every bundle in order of stamps and keep the answers in ``log``.

    Args:
        recording: Where the bundles come from; its rig is the nominal one.
        make_estimator: Constructs the estimator.
        log: Grows by one entry a bundle and is finished at the end.
        on_bundle: Called with how many bundles are done, and how many there are.

    Raises:
        InputError: The recording holds no bundle.
        EstimatorError: The estimator raised or answered nonsense.
    """
    with _blaming("while it was made"):
        estimator = make_estimator(recording.rig)
    for done, bundle in enumerate(recording.bundles(), start=1):
        with _blaming(f"at bundle {done} of {recording.bundle_count}"), log.measuring():
            estimate = estimator.update(bundle)
            _check(estimate, recording.rig)
        log.add(bundle, estimate)
        on_bundle(done, recording.bundle_count)
    if not log.entries:
        raise InputError(f"{recording.path}: holds no image of the rig's cameras: {recording.rig.names_text}")
    with _blaming("at its close"), log.measuring():
        final = estimator.close()
        _check(final, recording.rig)
    log.finish(final)


@contextmanager
def _blaming(when: str) -> Iterator[None]:
    try:
        yield
    except InputError:
        raise
    except Exception as error:
        reason = " ".join(f"{type(error).__name__}: {error}".split())
        raise EstimatorError(f"failed {when}: {reason}") from error


def _check(answer: object, rig: Rig) -> None:
    if not isinstance(answer, Estimate):
        raise TypeError(f"got {type(answer).__name__} as an answer, wanted an Estimate")
    missing = [name for name in rig.cameras if name not in answer.cameras]
    if missing:
        raise ValueError(f"the estimate lacks the camera {', '.join(missing)}")
