"""The table that ends a sweep."""

import pandas as pd

from eval.sweep_results import COLUMNS, ROTATION, TRANSLATION, summary_rows


def rows_of(
    seed: int, rotation: float | None, translation: float | None, reason: str | None = None
) -> list[tuple[object, ...]]:
    run = ("drive", seed, "online", "abc")
    return [
        (*run, ROTATION, rotation, "deg", "lower", reason),
        (*run, TRANSLATION, translation, "mm", "lower", reason),
        (*run, "cost.cpu_s", 99.0, "s", "lower", None),
    ]


def test_a_line_a_seed_and_the_median_over_those_that_have_a_value() -> None:
    rows = [*rows_of(0, 0.1, 10.0), *rows_of(1, 0.3, 30.0), *rows_of(2, None, None, "it died")]
    table = summary_rows(pd.DataFrame(rows, columns=list(COLUMNS)))
    assert table == [
        ("drive", "online", "0", "0.100", "10.0", ""),
        ("drive", "online", "1", "0.300", "30.0", ""),
        ("drive", "online", "2", "-", "-", "it died"),
        ("drive", "online", "median", "0.200", "20.0", ""),
    ]
