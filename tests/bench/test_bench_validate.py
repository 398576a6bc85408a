"""What comparing with a log costs, and how well and how fast numbers of a robot are found."""

import resource
from pathlib import Path
from statistics import median

import pytest

from tests.unit.validate.fitting.test_fit import LAB, SPEEDS, log_of, speeds_run_text
from tests.unit.validate.support import EXAMPLE, run_of
from vrts.base.units import DEG
from vrts.report.formats.run_csv import run_csv
from vrts.validate.comparison import read_and_compare
from vrts.validate.fitting import fit_robot
from vrts.validate.log.log import GivenLog
from vrts.validate.offsets import Wanted
from vrts.validate.reports.comparison_page import comparison_page
from vrts.validate.reports.comparison_text import comparison_text
from vrts.validate.synthetic import Imperfect

ROUNDS = 5
MINUTE = (
    (EXAMPLE / "path.v2")
    .read_bytes()
    .replace(b"MOVES p2", b"FOR i = 1 TO 4\n MOVES p2")
    .replace(b"MOVES p1", b"MOVES p1\n END")
)


def processor_s() -> float:
    used = resource.getrusage(resource.RUSAGE_SELF)
    return used.ru_utime + used.ru_stime


def test_a_log_of_a_minute_at_100_hz() -> None:
    run = run_of(MINUTE)
    data = "".join(run_csv(run, 100.0)).encode()
    for name, wanted in (("time", Wanted()), ("time, base, tool", Wanted(True, True, True))):
        comparing: list[float] = []
        for _ in range(ROUNDS):
            begin = processor_s()
            read_and_compare(run, GivenLog("log.csv", (data,)), wanted)
            comparing.append(processor_s() - begin)
        print(
            f"\n{run.horizon_s:.0f} s at 100 Hz ({len(data):,} bytes), fit of {name}:"
            f" {median(comparing):.2f} s of processor time"
        )
    found = read_and_compare(run, GivenLog("log.csv", (data,)), Wanted())
    begin = processor_s()
    comparison_text(found)
    page = comparison_page(found, "minute.v2")
    print(f"text and page of {len(page):,} bytes: {processor_s() - begin:.2f} s")


@pytest.mark.parametrize("logs", [1, 2])
def test_numbers_of_a_robot(logs: int, tmp_path: Path) -> None:
    true = run_of(speeds_run_text(), LAB, tmp_path)
    assumed = run_of(speeds_run_text())
    given = [
        GivenLog(f"{k}.csv", (log_of(true, Imperfect(seed=k, clock_s=3.0 * k)),))
        for k in range(logs)
    ]
    begin = processor_s()
    found = fit_robot(assumed, given)
    spent = processor_s() - begin
    assert found.blend_time is not None
    off = [
        abs(speed.value / (v * DEG) - 1.0)
        for speed, v in zip(found.speeds, SPEEDS, strict=True)
        if speed is not None
    ]
    assert len(off) == 6
    acceleration = found.acceleration_time.value / 0.28 - 1.0
    corner = found.blend_time.value / 0.392 - 1.0
    print(
        f"\n{logs} synthetic log{'s' if logs > 1 else ''}, {found.motions} motions: fitted in"
        f" {spent:.1f} s of processor time; speeds off by at most {100 * max(off):.2f} %,"
        f" acceleration by {100 * abs(acceleration):.2f} %, corners by {100 * abs(corner):.2f} %"
    )
    assert max(*off, abs(acceleration), abs(corner)) < 0.02
