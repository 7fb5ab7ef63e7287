"""Grouping by stamps: tolerance, order, bounds."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import pytest

from estimator.bundling import Bundler, Stamped, period_ns

MS = 1_000_000


def group(items: Iterable[tuple[str, float]], **counts: int) -> list[tuple[float, list[str]]]:
    """Group (camera, stamp in ms) at 10 Hz with reference ``a``."""
    bundler: Bundler[None] = Bundler(100.0 * MS, "a")
    stream = (Stamped(round(ms * MS), camera, None) for camera, ms in items)
    groups = [(stamp / MS, [each.camera for each in members]) for stamp, members in bundler.groups(stream)]
    assert {name: getattr(bundler, name) for name in counts} == counts
    return groups


def test_equal_stamps_are_one_group() -> None:
    assert group([("b", 0), ("a", 0), ("a", 100), ("b", 100)]) == [(0, ["a", "b"]), (100, ["a", "b"])]


def test_near_stamps_are_one_group_with_the_reference_s_stamp() -> None:
    assert group([("b", -10), ("a", 5), ("c", 20)]) == [(5, ["b", "a", "c"])]


def test_without_the_reference_the_median_is_the_stamp() -> None:
    assert group([("b", 0), ("c", 7), ("d", 9)]) == [(7, ["b", "c", "d"])]


def test_far_stamps_are_two_groups() -> None:
    assert group([("a", 0), ("b", 30)]) == [(0, ["a"]), (30, ["b"])]


def test_no_camera_is_twice_in_a_group() -> None:
    assert group([("a", 0), ("b", 1), ("b", 20)]) == [(0, ["a", "b"]), (20, ["b"])]


def test_a_chain_of_near_stamps_ends() -> None:
    chain = [(name, 20.0 * index) for index, name in enumerate("abcdef")]
    assert [len(members) for _, members in group(chain)] == [3, 3]


def test_a_faster_camera_fills_the_gaps() -> None:
    items = [("a", 0), ("b", 0), ("b", 33), ("b", 67), ("a", 100), ("b", 100)]
    assert [members for _, members in group(items)] == [["a", "b"], ["b"], ["b"], ["a", "b"]]


def test_order_within_half_a_second_does_not_matter() -> None:
    assert group([("a", 0), ("a", 100), ("a", 400), ("b", 0), ("b", 100)])[:2] == [
        (0, ["a", "b"]),
        (100, ["a", "b"]),
    ]


def test_what_comes_far_too_late_is_left_out_and_counted() -> None:
    items = [("a", 100.0 * i) for i in range(20)] + [("b", 0)]
    assert ["b"] not in [members for _, members in group(items, late_count=1)]


def test_a_repeated_stamp_is_left_out_and_counted() -> None:
    assert group([("a", 0), ("a", 0)], repeated_count=1) == [(0, ["a"])]


def test_only_half_a_second_is_held() -> None:
    taken = 0

    def endless() -> Iterator[Stamped[None]]:
        nonlocal taken
        while True:
            yield Stamped(taken * 100 * MS, "a", None)
            taken += 1

    groups = Bundler[None](100.0 * MS, "a").groups(endless())
    for _ in range(50):
        next(groups)
    assert taken <= 50 + 8


@pytest.mark.parametrize(
    ("stamps_ms", "expected_ms"),
    [([0, 100, 200, 500], 100), ([200, 0, 100, 100], 100), ([7], None), ([], None)],
)
def test_the_period_is_the_median_gap(stamps_ms: list[int], expected_ms: int | None) -> None:
    period = period_ns([stamp * MS for stamp in stamps_ms])
    assert period == (None if expected_ms is None else expected_ms * MS)
