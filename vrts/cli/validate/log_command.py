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
    warn,
    write_file,
)
from vrts.cli.shared.options import (
    Language,
    color_option,
    file_option,
    form_option,
    language_options,
    overwrite_option,
)
from vrts.cli.validate.log_files import given_columns, given_log
from vrts.cli.validate.shared import NOT_INSTALLED, run_of, setting_options
from vrts.pipeline.where import Where

if TYPE_CHECKING:
    from vrts.engine.run import Run
    from vrts.validate.comparison import Comparison
    from vrts.validate.log.log import GivenLog
    from vrts.validate.offsets import Wanted

EPILOG = """\b
The log: a table of text. Its first line names the columns, in any order:
  time_s                   or ms, or a time of day or date; any clock
  jt1_deg .. jt6_deg       joints as VAL counts them; also [rad]
  x_mm y_mm z_mm           the tool's tip in the robot's base frame; also [m]
Joints or positions or both. The names tell the units: `JT1 [rad]` or `x_m`. Other
columns are ignored. Commas, semicolons, tabs or blanks between values; decimal
points or commas; lines that begin with # are comments; empty fields and nan are
missing values. `vrts run PROGRAM --csv` writes such a table.

\b
vrts also reads as they are: CSV of RTDE (`actual_q_0`) and of PlotJuggler
(`/joint_states/joint_1/position`), bags of ROS 2 with joint states (.mcap, .db3, or
their folder; needs vrts[ros]), arrays of MATLAB (`save -v7`; needs vrts[validate]).
For other names give `--columns columns.toml`, with the names, units in brackets, and
how the robot counts compared with VAL:
  time = "stamp [ms]"
  joints = ["a1 [rad]", "a2 [rad]", "a3 [rad]", "a4 [rad]", "a5 [rad]", "a6 [rad]"]
  position = ["px [m]", "py [m]", "pz [m]"]
  count.sign = [1, -1, 1, 1, 1, 1]
  count.add_deg = [0, 90, 0, 0, 0, 0]

\b
Examples:
  vrts validate path.v2 --log robot.csv
  vrts validate path.v2 --log robot.csv --align time,base --html report.html --record both.rrd
  vrts validate path.v2 --scene cans-on-bases --log robot.csv --json
  vrts validate path.v2 --log bag_2026_11_24 --log robot.csv --columns columns.toml
  vrts validate speeds.v2 --log day1.csv --log day2.csv --fit -o robot.toml
  vrts validate path.v2 --log robot.csv --identify
"""
OFFSETS = ("time", "base", "tool")


@click.command(name="log", epilog=EPILOG)
@click.argument("program")
@file_option(
    "--log",
    "logs",
    multiple=True,
    required=True,
    help="Log of the real robot, or a folder with a bag of ROS 2; may be given several times.",
)
@file_option("--columns", help="A file that says which columns of the logs hold what.")
@click.option(
    "--align",
    default="time",
    show_default=True,
    help="Offsets to fit, with commas between: time, base, tool; or none.",
)
@click.option(
    "--within",
    type=click.FloatRange(0.0),
    help="Exit status 1 if the tool is farther off than this [mm].",
)
@file_option("--html", help="Write a report with figures.")
@file_option("--record", help="Write a recording (.rrd).")
@form_option("full", "json")
@click.option(
    "--fit", is_flag=True, help="Find out speeds, acceleration and corners; needs vrts[validate]."
)
@click.option("--identify", is_flag=True, help="Name what is wrong with the robot.")
@file_option("-o", "--output", help="With --fit or --identify: the lab to write.")
@overwrite_option()
@setting_options
@language_options
@color_option
@guarded
def command(
    program: str,
    logs: Sequence[Path],
    columns: Path | None,
    align: str,
    within: float | None,
    html: Path | None,
    record: Path | None,
    form: str,
    fit: bool,
    identify: bool,
    output: Path | None,
    overwrite: bool,
    where: Where,
    entry: str | None,
    language: Language,
    color: str,
) -> None:
    """Compare the log of a real robot with the run of PROGRAM.

    It prints the errors of the path and of the joints, and how late each motion was, before and
    after fitting the offsets. Positions are those of the tool's tip in the frame of the robot's
    base. With --fit it prints speeds, acceleration and corners of the robot instead, and writes
    them into a lab, in place of what was assumed. With --identify the first sentence says what is
    wrong with the robot: joints, links, tool, base, clock, speeds or servos.

    `vrts validate simulate` makes a log to practise with, and `vrts validate camera` draws the
    simulated robot over real pictures; each has its own `--help`.
    """
    os.environ.setdefault(
        "OPENBLAS_NUM_THREADS", "1"
    )  # before numpy: small matrices, busy machines
    for path in (html, record, output):
        if path is not None and path.exists() and not overwrite:
            fail(f"`{path}` is there already", ("give another name, or `--overwrite`",))
    if fit and identify:
        fail("--fit and --identify are two questions", ("ask one after the other",))
    asked = "--fit" if fit else "--identify"
    if fit and html is not None:
        fail("--html belongs to a comparison and to --identify, not to --fit")
    if (fit or identify) and (record is not None or within is not None):
        fail(f"--record and --within belong to a comparison, not to {asked}")
    if identify and len(logs) > 1 and (output is not None or html is not None):
        fail("-o and --html take one log", ("identify one log at a time for them",))
    if not (fit or identify) and output is not None:
        fail("-o belongs to --fit and --identify", ("reports are written by --html and --record",))
    if not fit and len(logs) > 1 and (html is not None or record is not None):
        fail("--html and --record show one log", ("compare one log at a time for them",))
    as_json = form == "json"
    wanted, chosen = _wanted(align), given_columns(columns, color)
    run, name = run_of(program, where, entry, language, color)
    given = [given_log(path, chosen) for path in logs]
    if fit:
        _fit(run, given, output, as_json=as_json, color=color)
        return
    if identify:
        sys.exit(_identify(run, given, name, output, html, as_json=as_json, color=color))
    found = _compared(run, given, wanted, color)
    _show(found, as_json=as_json)
    _write(found[0], name, html, record)
    sys.exit(max(_status(one, within) for one in found))


def _wanted(align: str) -> "Wanted":
    from vrts.validate.offsets import Wanted

    words = [word.strip().lower() for word in align.split(",") if word.strip()]
    unknown = [word for word in words if word not in (*OFFSETS, "none")]
    if unknown or ("none" in words and len(words) > 1):
        fail(f"--align takes {', '.join(OFFSETS)} or none, not `{align}`")
    return Wanted(*(name in words for name in OFFSETS))


def _compared(
    run: "Run", logs: "Sequence[GivenLog]", wanted: "Wanted", color: str
) -> "list[Comparison]":
    from vrts.validate.comparison import read_and_compare

    found: list[Comparison] = []
    for log in logs:
        found.append(read_and_compare(run, log, wanted))
        show_diagnostics(found[-1].findings, color)
    return found


def _show(found: "Sequence[Comparison]", *, as_json: bool) -> None:
    """Print the comparison of one log as it is, of several one after the other."""
    if as_json:
        from vrts.report.formats.json_text import json_text
        from vrts.validate.reports.comparison_json import comparison_json

        each = [comparison_json(one) for one in found]
        out(json_text(each[0] if len(each) == 1 else {"comparisons": each}))
    else:
        from vrts.validate.reports.comparison_text import comparison_text

        out("\n\n".join(comparison_text(one) for one in found))


def _status(found: "Comparison", within: float | None) -> int:
    from vrts.base.units import MM
    from vrts.validate.errors import lengths, measures

    off = measures(lengths(found.after) / MM).largest
    if within is None or off <= within:
        return HOLDS
    warn(f"the tool is up to {off:.2f} mm off, more than {within:g} mm")
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
    run: "Run", logs: "Sequence[GivenLog]", output: Path | None, *, as_json: bool, color: str
) -> None:
    try:
        from vrts.validate.fitting import fit_robot
    except ModuleNotFoundError:
        fail(NOT_INSTALLED, status=WRONG)
    from vrts.validate.fitted_files import fitted_json, fitted_text, lab_file

    found = fit_robot(run, logs)
    show_diagnostics(found.findings, color)
    if as_json:
        from vrts.report.formats.json_text import json_text

        out(json_text(fitted_json(found)))
    else:
        out(fitted_text(found))
    if output is not None:
        write_file(output, lab_file(found).encode())
        say(f"wrote {output}")


def _identify(
    run: "Run",
    logs: "Sequence[GivenLog]",
    name: str,
    output: Path | None,
    html: Path | None,
    *,
    as_json: bool,
    color: str,
) -> int:
    """Print what is wrong, and return the status: 1 where the model does not fit."""
    from vrts.validate.identified_files import identified_lab
    from vrts.validate.identify.identify import identify
    from vrts.validate.reports.identified_text import identified_text

    found = [identify(run, log) for log in logs]
    for one in found:
        show_diagnostics(one.findings, color)
    if as_json:
        from vrts.report.formats.json_text import json_text
        from vrts.validate.reports.identified_json import identified_json

        each = [identified_json(one) for one in found]
        out(json_text(each[0] if len(each) == 1 else {"identified": each}))
    else:
        out("\n\n".join(identified_text(one) for one in found))
    if output is not None:
        write_file(output, identified_lab(found[0]).encode())
        say(f"wrote {output}")
    if html is not None:
        from vrts.validate.reports.identified_page import identified_page

        write_file(html, identified_page(found[0], name).encode())
        say(f"wrote {html}")
    return HOLDS if all(one.fits for one in found) else WRONG
