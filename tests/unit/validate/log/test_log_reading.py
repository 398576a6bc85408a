"""Logs as people have them: read right with a note, or refused with what was expected."""

import re
from collections.abc import Callable

import numpy as np
import pytest

from tests.unit.validate.support import Array, path_run
from vrts.base.diagnostic import Diagnostic
from vrts.base.units import DEG, MM
from vrts.pipeline.refused import Refused
from vrts.validate.log.log import GivenLog, RobotLog, read_log
from vrts.validate.sampling import extent_of, sampled

TIMES = np.arange(0.0, 16.5, 0.05)


def table(
    delimiter: str = ",",
    comma: bool = False,
    names: str = "time_s jt1_deg jt2_deg jt3_deg jt4_deg jt5_deg jt6_deg x_mm y_mm z_mm",
    scales: tuple[float, float, float] = (1.0, 1.0, 1.0),
) -> str:
    """Return a log of the closed path.

    Args:
        delimiter: Between values.
        comma: As the decimal sign.
        names: Of the columns.
        scales: What s, degrees and mm are multiplied by.
    """
    samples = sampled(path_run(), TIMES)
    rows = np.column_stack(
        (
            TIMES * scales[0],
            samples.joints / DEG * scales[1],
            samples.positions / MM * scales[2],
        )
    )
    lines = [delimiter.join(names.split())]
    lines += [delimiter.join(f"{value:.6f}" for value in row) for row in rows]
    text = "\n".join(lines) + "\n"
    return re.sub(r"(?<=\d)\.(?=\d)", ",", text) if comma else text


def read(text: str | bytes) -> RobotLog:
    data = text.encode() if isinstance(text, str) else text
    return read_log(GivenLog("log.csv", (data,)), extent_of(path_run()))


def refused(text: str | bytes) -> Diagnostic:
    with pytest.raises(Refused) as caught:
        read(text)
    (found,) = caught.value.diagnostics
    return found


def codes(log: RobotLog) -> list[str]:
    return [d.rule.code for d in log.findings]


def same(log: RobotLog) -> bool:
    expected = sampled(path_run(), TIMES)
    assert log.joints is not None
    assert log.positions is not None

    def near(a: Array, b: Array, by: float) -> bool:
        return a.shape == b.shape and bool(np.abs(a - b).max() < by)

    return (
        near(log.times, TIMES, 1e-5)
        and near(log.joints, expected.joints, 1e-6)
        and near(log.positions, expected.positions, 1e-6)
    )


ODD = "timestamp J1[deg] J2[deg] joint3[°] q4(deg) Axis5_deg JT6[Deg] tcp_x[mm] Y_mm z[mm]"
RAD = "t[ms] jt1[rad] jt2[rad] jt3[rad] jt4[rad] jt5[rad] jt6[rad] x[m] y[m] z[m]"


@pytest.mark.parametrize(
    ("text", "notes"),
    [
        (lambda: table(), []),
        (lambda: table("\t"), []),
        (lambda: table(" "), []),
        (lambda: table("   "), []),
        (lambda: table(";"), []),
        (lambda: table(";", comma=True), ["V888"]),
        (lambda: table("\t", comma=True), ["V888"]),
        (lambda: table(names=ODD), ["V888"]),
        (lambda: table(names=RAD, scales=(1e3, DEG, MM)), []),
        (lambda: table(names="t j1 j2 j3 j4 j5 j6 x y z"), ["V888"] * 3),
        (
            lambda: table(names="t j1 j2 j3 j4 j5 j6 x y z", scales=(1e3, DEG, MM)),
            ["V888"] * 3,
        ),
        (lambda: "# made on Monday\n\n" + table().replace("\n", "\r\n"), []),
        (lambda: "# " + table(), []),
        (lambda: "\ufeff" + table(), []),
        (lambda: table().replace("time_s", '"time_s"'), []),
        (lambda: table().replace("time_s", "o_deg,t_deg,time_s").replace("\n", "\n1,2,", 0), None),
    ],
)
def test_read_right(text: Callable[[], str], notes: list[str] | None) -> None:
    if notes is None:  # more columns than are used
        lines = table().splitlines()
        rows = [f"0,0,{line},on" for line in lines[1:]]
        log = read("\n".join([f"o_deg,t_deg,{lines[0]},held", *rows]))
        notes = []
    else:
        log = read(text())
    assert same(log)
    assert codes(log) == notes


def test_old_machines_write_other_bytes() -> None:
    degrees = table(names=ODD)
    assert same(read(degrees.encode("latin-1")))
    assert same(read(degrees.encode("utf-16")))


def test_times_of_day_and_dates_are_times() -> None:
    lines = table().splitlines()
    for form in ("12:00:{:06.3f}", "2026-11-21T23:59:{:06.3f}", "2026-11-21 08:00:{:06.3f}+01:00"):
        rows = [
            f"{form.format(t)},{line.split(',', 1)[1]}"
            for t, line in zip(TIMES, lines[1:], strict=True)
        ]
        found = read("\n".join([lines[0].replace("time_s", "time"), *rows])).times
        assert found - found[0] == pytest.approx(TIMES, abs=1e-3)


def test_missing_values_are_left_out_and_counted() -> None:
    lines = table().splitlines()
    lines[10] = ",".join([lines[10].split(",")[0], *[""] * 6, *lines[10].split(",")[7:]])
    lines[20] = ",".join([*lines[20].split(",")[:9], "NaN"])
    log = read("\n".join(lines))
    assert log.joints is not None
    assert log.positions is not None
    assert np.flatnonzero(~np.isfinite(log.joints).all(axis=1)).tolist() == [9]
    assert np.flatnonzero(~np.isfinite(log.positions).all(axis=1)).tolist() == [19]
    assert [d.headline for d in log.findings] == [
        "joints are incomplete in 1 of 330 rows: left out",
        "positions of the tool are incomplete in 1 of 330 rows: left out",
    ]


def test_gaps_are_told_and_not_filled() -> None:
    lines = table().splitlines()
    log = read("\n".join(lines[:100] + lines[140:200] + lines[230:]))
    (gap,) = log.findings
    assert gap.rule.code == "V886"
    assert gap.headline == "the log has 2 gaps"
    assert gap.notes[0] == (
        "expected a row every 50 ms; none from 4.900 to 6.950 s, 9.900 to 11.450 s"
    )
    assert len(log.times) == 330 - 70


def test_repeated_time_stamps_are_left_out() -> None:
    lines = table().splitlines()
    log = read("\n".join([*lines[:50], lines[49], *lines[50:]]))
    assert same(log)
    assert codes(log) == ["V888"]


def test_a_missing_joint_leaves_the_positions() -> None:
    log = read(table(names="time_s jt1_deg jt2_deg jt3_deg rpm jt5_deg jt6_deg x_mm y_mm z_mm"))
    assert log.joints is None
    assert log.positions is not None
    (found,) = log.findings
    assert (found.rule.code, found.headline) == ("V883", "joint 4 is missing in the log")
    assert found.notes == ("only positions of the tool are compared",)


JOINTS = "time_s jt1_deg jt2_deg jt3_deg jt4_deg jt5_deg jt6_deg a b c"


@pytest.mark.parametrize(
    ("text", "code", "headline", "came"),
    [
        (lambda: "", "V880", "`log.csv` is no table of text", "the file is empty"),
        (lambda: "PK\x03\0\0\1", "V880", "`log.csv` is no table of text", "no text"),
        (
            lambda: "\n".join(table().splitlines()[1:]),
            "V881",
            "`log.csv` cannot be read as a table",
            "numbers, but no line that names the columns",
        ),
        (
            lambda: table(comma=True),
            "V881",
            "`log.csv` cannot be read as a table",
            "20 values under 10 names",
        ),
        (lambda: "# nothing\n", "V881", "`log.csv` cannot be read as a table", "only comments"),
        (lambda: "time_s,x_mm\n", "V881", "`log.csv` cannot be read as a table", "no values"),
        (
            lambda: table().replace("time_s", "when"),
            "V882",
            "no column holds the time",
            "the names of the columns",
        ),
        (
            lambda: table(names="time_s a b c d e f g h i"),
            "V882",
            "no column holds a joint or a position of the tool",
            "the names of the columns",
        ),
        (
            lambda: table().replace("jt2_deg", "jt1[deg]"),
            "V882",
            "columns `jt1_deg` and `jt1[deg]` say the same",
            "the names",
        ),
        (
            lambda: table(names=JOINTS).replace("jt4_deg", "rpm").replace("jt6_deg", "amps"),
            "V883",
            "joints 4, 6 are missing in the log",
            "expected six joints, found 4",
        ),
        (
            lambda: table().replace(",90.000000", ",stuck", 1),
            "V884",
            "`stuck` in column `jt3_deg` is no number",
            "expected a number here",
        ),
        (
            lambda: "\n".join(table().splitlines() + table().splitlines()[1:20]),
            "V885",
            "the time in the log goes backward",
            "0 s after 16.45 s",
        ),
        (
            lambda: "\n".join(table().splitlines()[:5]),
            "V885",
            "the log has 4 rows with a time",
            "expected at least 10 rows",
        ),
        (
            lambda: table(scales=(1.0, DEG, 1.0)),
            "V887",
            "the joints in the log are not in deg, it seems, but in rad",
            "`jt1_deg` says deg",
        ),
        (
            lambda: table(scales=(1.0, 1.0, MM)),
            "V887",
            "the position in the log is not in mm, it seems, but in m",
            "`x_mm` says mm",
        ),
        (
            lambda: table(scales=(1e3, 1.0, 1.0)),
            "V887",
            "the time in the log is not in s, it seems, but in ms",
            "`time_s` says s",
        ),
    ],
)
def test_refused_with_what_was_expected_and_what_came(
    text: Callable[[], str], code: str, headline: str, came: str
) -> None:
    found = refused(text())
    assert (found.rule.code, found.headline) == (code, headline)
    label = found.primary.text if found.primary else ""
    assert came in " ".join((label, *found.notes))
    assert "expected" in " ".join((label, *found.notes))


def test_a_log_says_that_it_is_synthetic() -> None:
    assert not read(table()).synthetic
    assert read("# SYNTHETIC: made by a computer\n" + table()).synthetic
