"""What an estimator costs: CPU time inside its calls, and memory while it runs.

CPU time of this process counts only inside ``measuring()``, so reading and drawing are left out; child
processes belong to the estimator wholly. Memory cannot be told apart within a process: it is the whole
process with its children, sampled after calls.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager

import psutil

_SAMPLE_EVERY_S = 0.25


class UsageMeter:
    """Adds up CPU seconds and remembers the peak of resident memory."""

    def __init__(self) -> None:
        self._process = psutil.Process()
        self._inside_s = 0.0
        self._children_before_s = self._children_cpu_s()
        self._next_sample_s = 0.0
        self._peak_bytes = 0
        self.call_count = 0

    @contextmanager
    def measuring(self) -> Iterator[None]:
        """Count the CPU time of the block, all threads, as the estimator's."""
        started_s = time.process_time()
        try:
            yield
        finally:
            self._inside_s += time.process_time() - started_s
            self.call_count += 1
            self._sample_memory()

    @property
    def cpu_s(self) -> float:
        return self._inside_s + self._children_cpu_s() - self._children_before_s

    @property
    def peak_rss_mb(self) -> float:
        return self._peak_bytes / 1e6

    def _sample_memory(self) -> None:
        now_s = time.monotonic()
        if now_s < self._next_sample_s:
            return
        self._next_sample_s = now_s + _SAMPLE_EVERY_S
        resident = self._process.memory_info().rss
        for child in self._process.children(recursive=True):
            try:
                resident += child.memory_info().rss
            except psutil.Error:  # it ended between being listed and being asked
                continue
        self._peak_bytes = max(self._peak_bytes, resident)

    def _children_cpu_s(self) -> float:
        """CPU seconds of all children, living and ended."""
        own = self._process.cpu_times()
        total_s = own.children_user + own.children_system
        for child in self._process.children(recursive=True):
            try:
                times = child.cpu_times()
            except psutil.Error:
                continue
            total_s += times.user + times.system
        return float(total_s)
