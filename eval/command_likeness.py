"""``rigtrue likeness``: do these frames look like a real street to a feature tracker?"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated

import typer

_COLUMNS = ("statistic", "mean", "10th", "90th", "real_drives", "wanted", "mean_is", "spread_is")


def likeness_command(
    folder: Annotated[
        Path, typer.Argument(metavar="FOLDER", help="Frames of one forward camera, or a recording.")
    ],
    camera: Annotated[str, typer.Option(help="Which camera of a recording.")] = "front",
    spacing_m: Annotated[float, typer.Option(min=0.01, help="Metres between frames of a recording.")] = 1.0,
    rows: Annotated[str, typer.Option(metavar="A:B", help="Rows that count.")] = "81:320",
    scale: Annotated[
        float, typer.Option(min=0.05, max=8.0, help="Resize first, to bring the focal length to 457 px.")
    ] = 1.0,
    step: Annotated[int, typer.Option(min=1, help="Use every STEPth frame of a folder.")] = 1,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON instead of a table.")] = False,
) -> None:
    """Measure corners, gradients, spectrum and track survival, and compare them with two real drives."""
    from eval.likeness import REAL_DRIVES, compare_with_real
    from eval.likeness_frames import Cut, read_frames
    from eval.likeness_statistics import statistics_of
    from eval.print_table import print_table

    frames = read_frames(folder, camera, spacing_m, Cut(scale, _parse_rows(rows), step))
    results = compare_with_real(statistics_of(frames))
    if as_json:
        values = {
            each.name: {
                "mean": round(each.mean, 4),
                "p10": round(each.low, 4),
                "p90": round(each.high, 4),
                "real": list(REAL_DRIVES[each.name]),
                "wanted": [round(end, 4) for end in each.wanted],
                "mean_inside": each.inside,
                "spread_inside": each.spread_inside,
            }
            for each in results
        }
        print(json.dumps({"frames": len(frames), "size_px": frames[0].shape[::-1], "statistics": values}))
        return
    table = [
        (
            each.name,
            *(f"{value:.4g}" for value in (each.mean, each.low, each.high)),
            "{:g} .. {:g}".format(*REAL_DRIVES[each.name]),
            "{:.4g} .. {:.4g}".format(*each.wanted),
            _word(each.inside),
            _word(each.spread_inside),
        )
        for each in results
    ]
    print_table(_COLUMNS, table, right=_COLUMNS[1:4])
    print(f"{len(frames)} frames; wanted: the real drives' range, give or take 15 %")


def _parse_rows(text: str) -> tuple[int, int]:
    from estimator.errors import InputError

    first, _, end = text.partition(":")
    if not (first.isdecimal() and end.isdecimal() and int(first) + 16 <= int(end)):
        raise InputError(f"--rows: got {text!r}, wanted A:B with at least 16 rows between")
    return int(first), int(end)


def _word(inside: bool) -> str:
    return "inside" if inside else "outside"
