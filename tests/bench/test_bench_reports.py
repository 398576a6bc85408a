"""What reports of a 60 s run cost: page, still and recording, time and bytes."""

from collections.abc import Callable
from pathlib import Path
from statistics import median
from time import process_time

from tests.places import ROOT
from vrts.pipeline.assess import assess
from vrts.pipeline.request import Checks
from vrts.pipeline.requesting import request_for
from vrts.pipeline.settings import setting_for
from vrts.pipeline.where import Where
from vrts.report.assessment import Assessment
from vrts.report.page.page import page
from vrts.report.page.stills import contacts_of, page_stills
from vrts.report.picture import backdrop
from vrts.report.picture.moments import moment_picture
from vrts.report.recording import write_recording

ROUNDS = 9
EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
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
BACK_AND_FORTH = """\
  MOVES can1_grip
  CLOSEI
  DEPARTS 40
  APPROS base2_put, 60
  MOVES base2_put
  OPENI
  DEPARTS 150
  APPRO base2_put, 60
  MOVES base2_put
  CLOSEI
  DEPARTS 60
  APPROS can1_grip, 40
  MOVES can1_grip
  OPENI
  DEPARTS 150
"""
TOUCHING = (
    ".PROGRAM main()\n  SPEED 60 ALWAYS\n  OPENI\n  MOVE safe\n  APPRO can1_grip, 100\n"
    + 5 * BACK_AND_FORTH
    + ".END\n"
    + LOCATIONS
)


def cost(name: str, work: Callable[[], object]) -> float:
    """Return the median of the processor's time [ms], so that other work does not count."""
    taken: list[float] = []
    for _ in range(ROUNDS):
        begin = process_time()
        work()
        taken.append(1e3 * (process_time() - begin))
    print(f"{name}: median {median(taken):.0f} ms, best {min(taken):.0f} ms")
    return median(taken)


def _alone(a: Assessment) -> None:
    for kept in (backdrop.stage, backdrop.view, backdrop.backdrop):
        kept.cache_clear()
    page_stills(a)


def test_a_page_with_ten_contacts_and_four_stills(tmp_path: Path) -> None:
    program = tmp_path / "contacts.v2"
    program.write_text(TOUCHING)
    setting = setting_for(program, Where("cans-on-bases"))
    a = assess(request_for(program, setting=setting, checks=Checks(curve=True)))
    stills = page_stills(a)
    text = page(a, stills)
    print(f"\n{len(contacts_of(a))} contacts, page {len(text.encode()) / 1e6:.2f} MB")
    assert len(stills) == 4
    assert len(contacts_of(a)) == 10
    cost("four stills 480x360", lambda: page_stills(a))
    cost("the same where nothing is kept", lambda: _alone(a))
    assert cost("page", lambda: page(a, stills)) <= 60
    assert len(text.encode()) <= 2_000_000


def test_reports_of_a_minute(tmp_path: Path) -> None:
    program = tmp_path / "minute.v2"
    program.write_text(PROGRAM)
    setting = setting_for(program, Where("cans-on-bases"))
    a = assess(request_for(program, setting=setting, checks=Checks(curve=True)))
    assert a.run is not None
    print(f"\nrun of {a.run.horizon_s:.1f} s, {len(a.run.timeline.segments)} segments")
    picture = moment_picture(a)
    assert picture is not None
    recording = tmp_path / "run.rrd"
    stills = page_stills(a)
    text = page(a, stills)
    cost("still 480x360", lambda: moment_picture(a))
    assert cost("page", lambda: page(a, stills)) <= 60
    cost("recording", lambda: write_recording(a, recording))
    size = recording.stat().st_size
    print(f"page {len(text.encode()) / 1e6:.2f} MB, recording {size / 1e6:.2f} MB")
    assert len(text.encode()) <= 2_000_000
    assert size <= 3_000_000
    assert a.run.horizon_s > 50
