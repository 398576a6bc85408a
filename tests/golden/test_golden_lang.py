"""Example programs of the language reference and the IR they lower to.

After a change of the IR that is meant, `UPDATE_GOLDEN=1 pytest tests/golden/test_golden_lang.py`
writes the files anew.
"""

import os
from pathlib import Path

import pytest

from vrts.base.source import SourceFile
from vrts.ir.dump import dump
from vrts.ir.verify import verify
from vrts.lang.compiler import compile_source

PROGRAMS = sorted((Path(__file__).parent / "lang").glob("*.v2"))


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_ir(path: Path) -> None:
    compilation = compile_source(SourceFile(path.name, path.read_text("utf-8")))
    assert not [d for d in compilation.diagnostics if d.is_error]
    assert compilation.module is not None
    assert verify(compilation.module) == []
    golden = path.with_suffix(".ir")
    if os.environ.get("UPDATE_GOLDEN"):
        golden.write_text(dump(compilation.module), "utf-8")
    assert dump(compilation.module) == golden.read_text("utf-8")


def test_there_are_programs() -> None:
    assert len(PROGRAMS) >= 6
