"""What reports of a 60 s run cost: page, still and recording, time and bytes."""

from collections.abc import Callable
from pathlib import Path
from statistics import median
from time import process_time

from vrts.pipeline.assess import assess
from vrts.pipeline.settings import setting_for
from vrts.report.page import page
from vrts.report.picture import moment_picture
from vrts.report.recording import write_recording

ROUNDS = 9
EXAMPLE = Path(__file__).parent.parent.parent / "examples" / "01-cans-on-bases"
BODY = """\
  MOVE safe
  APPRO can1_grip, 100
  MOVES can1_grip
  CLOSEI
  DEPARTS 100
  MOVES can1_grip
  OPENI
  DEPARTS 150
"""
HITS = (EXAMPLE / "submissions" / "hits-base.v2").read_text()
_, _, LOCATIONS = HITS.partition(".END\n")
PROGRAM = ".PROGRAM main()\n  SPEED 60 ALWAYS\n  OPENI\n" + 14 * BODY + ".END\n" + LOCATIONS


def cost(name: str, work: Callable[[], object]) -> float:
    """Return the median of the processor's time [ms], so that other work does not count."""
    taken: list[float] = []
    for _ in range(ROUNDS):
        begin = process_time()
        work()
        taken.append(1e3 * (process_time() - begin))
    print(f"{name}: median {median(taken):.0f} ms, best {min(taken):.0f} ms")
    return median(taken)


def test_reports_of_a_minute(tmp_path: Path) -> None:
    program = tmp_path / "minute.v2"
    program.write_text(PROGRAM)
    setting = setting_for(program, scene="cans-on-bases", task=None)
    a = assess(program, setting=setting, curve=True)
    assert a.run is not None
    print(f"\nrun of {a.run.horizon_s:.1f} s, {len(a.run.timeline.segments)} segments")
    picture = moment_picture(a)
    assert picture is not None
    recording = tmp_path / "run.rrd"
    text = page(a, {"moment": picture})
    cost("still 480x360", lambda: moment_picture(a))
    cost("page", lambda: page(a, {"moment": picture}))
    cost("recording", lambda: write_recording(a, recording))
    size = recording.stat().st_size
    print(f"page {len(text.encode()) / 1e6:.2f} MB, recording {size / 1e6:.2f} MB")
    assert len(text.encode()) <= 2_000_000
    assert size <= 3_000_000
    assert a.run.horizon_s > 50
