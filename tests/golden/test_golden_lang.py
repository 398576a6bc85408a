"""Example programs and the IR they lower to.

The end of a file's name tells its dialect. After a change of the IR that is meant,
`UPDATE_GOLDEN=1 pytest tests/golden/test_golden_lang.py` writes the files anew.
"""

import os
import re
from pathlib import Path

import pytest

from vrts.base.source import SourceFile
from vrts.ir.dump import dump
from vrts.ir.verify import verify
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import AS, VAL, VAL2, VPLUS

DIALECTS = {".v2": VAL2, ".val": VAL, ".vplus": VPLUS, ".as": AS}
PROGRAMS = sorted(p for p in (Path(__file__).parent / "lang").iterdir() if p.suffix in DIALECTS)


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_ir(path: Path) -> None:
    source = SourceFile(path.name, path.read_text("utf-8"))
    compilation = compile_source(source, Options(DIALECTS[path.suffix]))
    assert not [d for d in compilation.diagnostics if d.is_error]
    assert compilation.module is not None
    assert verify(compilation.module) == []
    golden = path.with_suffix(".ir")
    if os.environ.get("UPDATE_GOLDEN"):
        golden.write_text(dump(compilation.module), "utf-8")
    assert dump(compilation.module) == golden.read_text("utf-8")


def test_all_examples_are_there() -> None:
    named = (re.match(r"; Example E(\d+) ", path.read_text("utf-8")) for path in PROGRAMS)
    assert {int(found[1]) for found in named if found} == set(range(1, 19))
