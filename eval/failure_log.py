"""Keep the traceback of a failed estimator beside the run folder that is not there."""

from __future__ import annotations

import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from eval.estimate import EstimatorError


@contextmanager
def keeping_traceback(out: Path) -> Iterator[None]:
    """Write the traceback to ``<out>.error.log`` if the estimator fails, remove an old one if it does not."""
    log = out.with_name(f"{out.name}.error.log")
    try:
        yield
    except EstimatorError as failure:
        log.write_text("".join(traceback.format_exception(failure)))
        raise EstimatorError(f"{failure}; traceback in {log}") from failure
    log.unlink(missing_ok=True)
