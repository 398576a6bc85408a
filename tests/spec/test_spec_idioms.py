"""Runs the tables of `idioms.md`: what is written is mended to what it means, by its own fix."""

import re
from pathlib import Path

import pytest

from vrts.base.diagnostic import Diagnostic
from vrts.base.mending import edits_of, with_edits
from vrts.base.source import SourceFile
from vrts.ir.dump import dump
from vrts.lang.compiler import Compilation, compile_source
from vrts.pipeline.compiling.fixing import fix_bytes

ROW = re.compile(r"^\| `(.+)` \| `(.+)` \|$", re.MULTILINE)
TEXT = (Path(__file__).parent / "idioms.md").read_text("utf-8")
ROWS = [tuple(part.replace("\\|", "|") for part in row.groups()) for row in ROW.finditer(TEXT)]
BESIDE = """
.PROGRAM pick
        READY
.END
.LOCATIONS
part 450 -120 -50 90 90 0
tray 450 120 -50 90 90 0
#safe 0 -90 90 0 0 0
.END
"""


def program(body: str) -> str:
    lines = "\n".join(line if line[0].isdigit() else f"        {line}" for line in body.split("↵"))
    return f".PROGRAM main\n{lines}\n.END{BESIDE}"


def compiled(text: str) -> Compilation:
    return compile_source(SourceFile("a.v2", text))


def errors(compilation: Compilation) -> list[Diagnostic]:
    return [d for d in compilation.diagnostics if d.is_error]


def steps(compilation: Compilation) -> str:
    """Return what a program does, whatever the numbers of its lines."""
    assert compilation.module is not None
    return re.sub(r"(?m)^( +\d+ +)\d+", r"\1", dump(compilation.module))


def test_there_are_rows() -> None:
    assert len(ROWS) > 100


@pytest.mark.parametrize(("written", "means"), ROWS)
def test_idiom(written: str, means: str) -> None:
    text = program(written)
    meant = compiled(program(means))
    assert errors(meant) == []
    (told,) = errors(compiled(text))
    assert told.fix is not None
    mended = with_edits(text, edits_of([told]))
    after = compiled(mended)
    assert errors(after) == [], mended
    assert steps(after) == steps(meant)
    fixed = fix_bytes(text.encode(), "a.v2")
    assert steps(compiled(fixed.after)) == steps(meant)
    assert fixed.applied
