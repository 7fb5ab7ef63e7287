"""The cache of recordings: renders once, notices damage, keeps its size, waits for others."""

import multiprocessing
import os
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from estimator.errors import InputError
from scenarios.cache import RecordingCache


class Renderer:
    """Writes a bag of some bytes and counts how often it was asked."""

    def __init__(self, size_bytes: int = 100) -> None:
        self.size_bytes = size_bytes
        self.calls = 0

    def __call__(self, bag: Path) -> None:
        self.calls += 1
        bag.mkdir()
        (bag / "bag.mcap").write_bytes(b"x" * self.size_bytes)


def use(cache: RecordingCache, digest: str, renderer: Callable[[Path], None]) -> bytes:
    with cache.recording(digest, renderer) as bag:
        return (bag / "bag.mcap").read_bytes()


def test_one_digest_renders_once(tmp_path: Path) -> None:
    cache, renderer = RecordingCache(tmp_path / "cache", 10**6), Renderer()
    assert use(cache, "aa", renderer) == use(cache, "aa", renderer)
    assert renderer.calls == 1


def test_a_flipped_byte_renders_again(tmp_path: Path) -> None:
    cache, renderer = RecordingCache(tmp_path, 10**6), Renderer()
    good = use(cache, "aa", renderer)
    (tmp_path / "aa" / "bag" / "bag.mcap").write_bytes(b"y" * 100)
    assert use(cache, "aa", renderer) == good
    assert renderer.calls == 2


def test_a_failed_rendering_leaves_nothing(tmp_path: Path) -> None:
    def fail(bag: Path) -> None:
        bag.mkdir()
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt), RecordingCache(tmp_path, 10**6).recording("aa", fail):
        pass
    assert [path.name for path in tmp_path.iterdir()] == ["aa.lock"]


def test_the_least_recently_used_recording_goes_first(tmp_path: Path) -> None:
    cache = RecordingCache(tmp_path, 1000)
    for name in ("aa", "bb"):
        use(cache, name, Renderer(300))
        os.utime(tmp_path / name, (0, 0))
    use(cache, "aa", Renderer())  # used again, so bb is now the oldest
    use(cache, "cc", Renderer(300))
    assert sorted(path.name for path in tmp_path.iterdir() if path.is_dir()) == ["aa", "cc"]


def test_a_recording_in_use_is_not_evicted(tmp_path: Path) -> None:
    cache = RecordingCache(tmp_path, 0)
    with cache.recording("aa", Renderer()) as bag:
        use(cache, "bb", Renderer())
        assert (bag / "bag.mcap").is_file()


def test_what_a_killed_rendering_left_goes_and_one_under_way_stays(tmp_path: Path) -> None:
    cache = RecordingCache(tmp_path, 10**6)
    Renderer()(tmp_path / "killed.partial")

    def render(bag: Path) -> None:
        use(cache, "bb", Renderer())
        Renderer()(bag)

    assert use(cache, "aa", render) == b"x" * 100
    assert sorted(path.name for path in tmp_path.iterdir() if path.is_dir()) == ["aa", "bb"]


def test_two_processes_render_once(tmp_path: Path) -> None:
    context = multiprocessing.get_context("spawn")
    workers = [context.Process(target=_render_slowly, args=(tmp_path,)) for _ in range(2)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join(60)
    assert [worker.exitcode for worker in workers] == [0, 0]
    assert len(list(tmp_path.glob("rendered-*"))) == 1


def _render_slowly(folder: Path) -> None:
    def render(bag: Path) -> None:
        (folder / f"rendered-{os.getpid()}").touch()
        time.sleep(0.5)
        Renderer()(bag)

    with RecordingCache(folder / "cache", 10**6).recording("aa", render) as bag:
        assert (bag / "bag.mcap").stat().st_size == 100


def test_a_cache_that_cannot_be_written_says_what_to_do(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with (
        pytest.raises(InputError, match="set RIGTRUE_CACHE"),
        RecordingCache(tmp_path / "file" / "cache", 1).recording("aa", Renderer()),
    ):
        pass


def test_the_environment_chooses_folder_and_size(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("RIGTRUE_CACHE", raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setenv("RIGTRUE_CACHE_GB", "0.5")
    assert RecordingCache.of_user() == RecordingCache(tmp_path / "rigtrue", 500_000_000)
    monkeypatch.setenv("RIGTRUE_CACHE_GB", "lots")
    with pytest.raises(InputError, match="RIGTRUE_CACHE_GB: got 'lots'"):
        RecordingCache.of_user()
