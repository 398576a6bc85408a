"""`vrts validate PROGRAM --log ROBOT.csv`."""

import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import (
    HOLDS,
    WRONG,
    fail,
    guarded,
    out,
    say,
    show_diagnostics,
    write_file,
)
from vrts.cli.shared.options import (
    Language,
    color_option,
    file_option,
    language_options,
    overwrite_option,
)
from vrts.cli.validate.shared import NOT_INSTALLED, run_of, setting_options
from vrts.pipeline.where import Where

if TYPE_CHECKING:
    from vrts.engine.run import Run
    from vrts.validate.comparison import Comparison
    from vrts.validate.offsets import Wanted

EPILOG = """\b
The log: a table of text. Its first line names the columns, in any order:
  time_s                   or ms, or a time of day or date; any clock
  jt1_deg .. jt6_deg       joints as VAL counts them; also [rad]
  x_mm y_mm z_mm           the tool's tip in the robot's base frame; also [m]
Joints or positions or both; units stand in the names, `JT1 [rad]` or `x_m`. Other
columns are passed over. Commas, semicolons, tabs or blanks between values; decimal
points or commas; lines that begin with # are comments; empty fields and nan are
missing values. `vrts run PROGRAM --csv` writes such a table.

\b
Examples:
  vrts validate path.v2 --log robot.csv
  vrts validate path.v2 --log robot.csv --align time,base --html report.html --record both.rrd
  vrts validate path.v2 --scene cans-on-bases --log robot.csv --json
  vrts validate speeds.v2 --log day1.csv --log day2.csv --fit -o robot.toml
"""
OFFSETS = ("time", "base", "tool")


@click.command(name="log", epilog=EPILOG)
@click.argument("program")
@file_option(
    "--log",
    "logs",
    multiple=True,
    required=True,
    help="Log of the real robot; several with --fit.",
)
@click.option(
    "--align",
    default="time",
    show_default=True,
    help="Offsets to fit, with commas between: time, base, tool; or none.",
)
@click.option(
    "--within", type=click.FloatRange(0.0), help="Exit with 1 if the tool is farther off, in mm."
)
@file_option("--html", help="Write a report with figures.")
@file_option("--record", help="Write a recording (.rrd).")
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
@click.option("--fit", is_flag=True, help="Find out numbers of the robot; needs vrts[validate].")
@file_option("-o", "--output", help="With --fit: a lab to write.")
@overwrite_option()
@setting_options
@language_options
@color_option
@guarded
def command(
    program: str,
    logs: Sequence[Path],
    align: str,
    within: float | None,
    html: Path | None,
    record: Path | None,
    as_json: bool,
    fit: bool,
    output: Path | None,
    overwrite: bool,
    where: Where,
    entry: str | None,
    language: Language,
    color: str,
) -> None:
    """Compare the log of a real robot with the run of PROGRAM.

    Tells the errors of the path and of the joints and how late each motion was, before and after
    the offsets were fitted. Positions are of the tool's tip in the frame of the robot's base.
    With --fit the log tells speeds, acceleration and corners of the robot instead; the lab that it
    writes takes the place of what was assumed. `vrts validate simulate --help` makes a log to
    practise with, `vrts validate camera --help` draws the simulated robot over real pictures.
    """
    os.environ.setdefault(
        "OPENBLAS_NUM_THREADS", "1"
    )  # before numpy: small matrices, busy machines
    for path in (html, record, output):
        if path is not None and path.exists() and not overwrite:
            fail(f"`{path}` is there already", ("give another name, or `--overwrite`",))
    run, name = run_of(program, where, entry, language, color)
    if fit:
        if html is not None or record is not None or within is not None:
            fail("--html, --record and --within belong to a comparison, not to --fit")
        _fit(run, logs, output, as_json=as_json, color=color)
        return
    if output is not None:
        fail("-o belongs to --fit", ("reports are written by --html and --record",))
    if len(logs) > 1:
        fail("one log is compared at a time", ("several are for --fit",))
    found = _compared(run, logs[0], _wanted(align))
    show_diagnostics(found.findings, color)
    _show(found, as_json=as_json)
    _write(found, name, html, record)
    sys.exit(_status(found, within))


def _wanted(align: str) -> "Wanted":
    from vrts.validate.offsets import Wanted

    words = [word.strip().lower() for word in align.split(",") if word.strip()]
    unknown = [word for word in words if word not in (*OFFSETS, "none")]
    if unknown or ("none" in words and len(words) > 1):
        fail(f"--align takes {', '.join(OFFSETS)} or none, not `{align}`")
    return Wanted(*(name in words for name in OFFSETS))


def _compared(run: "Run", path: Path, wanted: "Wanted") -> "Comparison":
    from vrts.pipeline.files import read_bytes, shown
    from vrts.validate.comparison import read_and_compare

    return read_and_compare(run, read_bytes(path), shown(path), wanted)


def _show(found: "Comparison", *, as_json: bool) -> None:
    if as_json:
        from vrts.report.formats.json_text import json_text
        from vrts.validate.reports.comparison_json import comparison_json

        out(json_text(comparison_json(found)))
    else:
        from vrts.validate.reports.comparison_text import comparison_text

        out(comparison_text(found))


def _status(found: "Comparison", within: float | None) -> int:
    from vrts.base.units import MM
    from vrts.validate.errors import lengths, measures

    off = measures(lengths(found.after) / MM).largest
    if within is None or off <= within:
        return HOLDS
    say(f"the tool is up to {off:.2f} mm off, more than {within:g} mm")
    return WRONG


def _write(found: "Comparison", name: str, html: Path | None, record: Path | None) -> None:
    if html is not None:
        from vrts.validate.reports.comparison_page import comparison_page

        write_file(html, comparison_page(found, name).encode())
        say(f"wrote {html}")
    if record is not None:
        from vrts.validate.reports.comparison_recording import write_both

        write_both(found, name, record)
        say(f"wrote {record}")


def _fit(
    run: "Run", logs: Sequence[Path], output: Path | None, *, as_json: bool, color: str
) -> None:
    try:
        from vrts.validate.fitting import fit_robot
    except ModuleNotFoundError:
        fail(NOT_INSTALLED, status=WRONG)
    from vrts.pipeline.files import read_bytes, shown
    from vrts.validate.fitted_files import fitted_json, fitted_text, lab_file

    found = fit_robot(run, [(shown(path), read_bytes(path)) for path in logs])
    show_diagnostics(found.findings, color)
    if as_json:
        from vrts.report.formats.json_text import json_text

        out(json_text(fitted_json(found)))
    else:
        out(fitted_text(found))
    if output is not None:
        write_file(output, lab_file(found).encode())
        say(f"wrote {output}")
