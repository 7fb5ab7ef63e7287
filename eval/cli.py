"""The command ``rigtrue``: one file a command, exit codes and one-line errors here."""

from __future__ import annotations

import errno
import sys
from collections.abc import Sequence

import typer

from estimator.errors import InputError
from eval.command_doctor import doctor_command
from eval.command_likeness import likeness_command
from eval.command_list import list_command
from eval.command_record import record_command
from eval.command_replay import replay_command
from eval.command_report import report_command
from eval.command_run import run_command
from eval.command_sweep import sweep_command

WRONG_REQUEST = 2
INTERRUPTED = 130
_DISK_ERRORS = {errno.ENOSPC, errno.EDQUOT, errno.EACCES, errno.EPERM, errno.EROFS}

app = typer.Typer(
    name="rigtrue",
    help="Calibrate the cameras of a car while it drives, and prove it.",
    add_completion=False,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
app.command("run")(run_command)
app.command("record")(record_command)
app.command("replay")(replay_command)
app.command("sweep")(sweep_command)
app.command("report")(report_command)
app.command("likeness")(likeness_command)
app.command("list")(list_command)
app.command("doctor")(doctor_command)


def main() -> None:
    """Run the command line of this process."""
    sys.exit(run_command_line(sys.argv[1:]))


def run_command_line(arguments: Sequence[str]) -> int:
    """Run one command line and return its exit code; a user's mistake is one line on standard error."""
    try:
        code = app(list(arguments) or ["--help"], prog_name="rigtrue", standalone_mode=False)
    except KeyboardInterrupt:
        return _complain("interrupted", INTERRUPTED)
    except InputError as error:
        return _complain(f"error: {error}", WRONG_REQUEST)
    except typer.TyperException as error:
        return _complain(f"error: {error.format_message()} (rigtrue --help tells more)", WRONG_REQUEST)
    except OSError as error:
        if error.errno not in _DISK_ERRORS:
            raise
        where = error.filename2 or error.filename or "disk"  # of a copy, the second one is written
        return _complain(f"error: {where}: {error.strerror}", WRONG_REQUEST)
    if code == INTERRUPTED:
        return _complain("interrupted", INTERRUPTED)
    return code if isinstance(code, int) else 0


def _complain(line: str, code: int) -> int:
    if line:
        print(" ".join(line.split()), file=sys.stderr)
    return code
