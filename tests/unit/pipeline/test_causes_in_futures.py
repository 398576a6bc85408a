"""What goes wrong in another future than the one that is shown has causes, too."""

from pathlib import Path

from tests.support_commands import vrts_text
from tests.unit.pipeline.test_proof_of_task import CHECK, FITS, written
from vrts.check.rules.hints import Hints
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Checks, Request
from vrts.pipeline.settings import load_task
from vrts.report.because import chain_lines
from vrts.why.chain import Chain

ASKS = '\n[prove]\nenvironment = "cell.toml"\n'
FREE = 'title = "a button"\n\n[[inputs]]\nsignal = 1002\nis = "free"\n'
LOWERS = """\
.PROGRAM main()
        MOVE before
        BREAK
        down = 100
        IF SIG(1002) THEN
                down = 500
        END
        MOVES SHIFT(before BY 0,0,-down)
        MOVE before
        MOVES behind
.END
.LOCATIONS
before 950 -130 200 90 90 0
behind 900 -300 100 90 90 0
.END
"""
FAILS = LOWERS.replace("MOVES SHIFT(before BY 0,0,-down)", "x = 1/(100-down)")


def chain_of(folder: Path, text: str, cell: str) -> Chain:
    setting = load_task(written(folder, ASKS, cell))
    a = assess(Request(ProgramFile(text.encode(), "prog.v2"), setting, checks=Checks(causes=True)))
    assert a.grade is not None
    pairs = zip(a.grade.losses, a.chains, strict=True)
    (found,) = (chain for loss, chain in pairs if loss.check == CHECK)
    return found


def test_a_contact_that_an_input_decides_leads_to_the_number(tmp_path: Path) -> None:
    found = chain_of(tmp_path, LOWERS, FREE)
    assert "in that future, at " in found.links[0].says
    assert all(link.time_s is None for link in found.links), "the replay shows another run"
    lines = [link.span.line for link in found.links if link.span is not None]
    assert lines[1:] == [8, 13, 6], "down = 500"
    assert chain_lines(found, Hints.NOTHING) == []


def test_an_error_leads_to_the_value(tmp_path: Path) -> None:
    text = FAILS.replace("down = 500", "down = 100").replace("down = 100", "down = 99", 1)
    found = chain_of(tmp_path, text, FREE)
    lines = [link.span.line for link in found.links if link.span is not None]
    assert 6 in lines, [link.says for link in found.links]


def test_a_property_leads_to_the_motion(tmp_path: Path) -> None:
    cell = (
        'title = "a gate"\n\n[[inputs]]\nsignal = 1001\nis = "pulsed"\noff_s = [0.5, 10.0]\n'
        'on_s = [5.0]\n\n[[never]]\ntitle = "in the gate while it is shut"\nsignals = [-1001]\n'
        "region_mm = { from = [800, -100, 0], to = [1000, 100, 300] }\n"
    )
    first, second = chain_of(tmp_path, FITS, cell).links
    assert first.says == "in that future, at 3.9 s, the tool goes to X 900 Y -300 Z 100"
    assert second.span is not None
    assert second.span.line == 9


def test_why_tells_them(tmp_path: Path) -> None:
    written(tmp_path, ASKS, FREE)
    (tmp_path / "prog.v2").write_text(LOWERS)
    said = vrts_text("why", "prog.v2", cwd=tmp_path).stdout
    assert "in that future" in said
    assert "line 6 `down = 500`" in said
