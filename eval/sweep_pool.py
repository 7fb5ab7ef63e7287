"""Run jobs on spawned processes; a worker that dies takes nobody else's run with it.

When a worker is killed the pool cannot say whose run it was: every run in flight is suspected, and repeated
alone at the end. A run that kills its worker even then has failed.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from types import FrameType

from eval.sweep_job import SweepJob, run_job

OnDone = Callable[[SweepJob, str | None], None]

DIED = "the worker process died: killed, or out of memory"
_is_busy = False


def run_jobs(jobs: Sequence[SweepJob], workers: int, on_done: OnDone) -> None:
    """Run all jobs; ``on_done`` hears of each one as it ends, with the reason if it failed."""
    waiting = deque(jobs)
    suspects: list[SweepJob] = []
    while waiting:
        suspects += _drain(waiting, workers, on_done)
    for job in suspects:
        if _drain(deque([job]), 1, on_done):
            on_done(job, DIED)


def _drain(waiting: deque[SweepJob], workers: int, on_done: OnDone) -> list[SweepJob]:
    """Run jobs until none waits, or a worker dies; return the jobs that were in flight then."""
    flying: dict[Future[str | None], SweepJob] = {}
    with _pool(workers) as pool:
        while waiting or flying:
            while waiting and len(flying) < workers:
                try:
                    future = pool.submit(_work, waiting[0])
                except BrokenProcessPool:
                    return list(flying.values())
                flying[future] = waiting.popleft()
            done, _ = wait(flying, return_when=FIRST_COMPLETED)
            dead = [future for future in done if isinstance(future.exception(), BrokenProcessPool)]
            for future in done.difference(dead):
                on_done(flying.pop(future), future.result())
            if dead:
                return list(flying.values())
    return []


@contextmanager
def _pool(workers: int) -> Iterator[ProcessPoolExecutor]:
    """Yield a pool of fresh processes (a fork would hang after rendering); end its work on an interrupt."""
    context = multiprocessing.get_context("spawn")
    pool = ProcessPoolExecutor(workers, mp_context=context, initializer=_prepare_worker)
    try:
        yield pool
    except BaseException:
        for process in multiprocessing.active_children():
            process.terminate()
        raise
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _prepare_worker() -> None:
    """Leave Ctrl-C to the parent, which asks its workers to stop by SIGTERM."""
    signal.signal(signal.SIGINT, lambda *_: None)
    signal.signal(signal.SIGTERM, _stop)


def _work(job: SweepJob) -> str | None:
    global _is_busy
    _is_busy = True
    try:
        return run_job(job)
    except KeyboardInterrupt:
        os._exit(1)  # asked to stop: a dead worker may hold the pool's queue, so never go back to it
    finally:
        _is_busy = False


def _stop(_signal: int, _frame: FrameType | None) -> None:
    """Unwind the run, so that it leaves nothing half-written; an idle worker just goes."""
    if not _is_busy:
        os._exit(0)
    raise KeyboardInterrupt
