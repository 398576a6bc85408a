"""Time against size: programs with more and more locations, steps, programs, motions, events."""

import time
from collections.abc import Callable

import pytest

from tests.support_programs import ALONE
from tests.unit.engine.test_growth import KINDS, simulated
from vrts.base.source import SourceFile
from vrts.check.judge import judge
from vrts.engine.controller import execute
from vrts.lang.compiler import compile_source
from vrts.run_files.loading import load_run
from vrts.run_files.saving import saved_bytes

FACTORS = {"motions": 5, "programs": 5, "steps": 10, "events": 10}


def took(call: Callable[[], object]) -> float:
    """Return the processor time of a call [ms]; a busy machine adds little."""
    begin = time.process_time()
    call()
    return 1e3 * (time.process_time() - begin)


@pytest.mark.parametrize("kind", KINDS)
def test_time_against_size(kind: str) -> None:
    text, size = KINDS[kind]
    size *= FACTORS.get(kind, 8)
    for count in (size, 2 * size, 4 * size):
        source = SourceFile("main.v2", text(count))
        compiling = took(lambda source=source: compile_source(source))
        module = compile_source(source).module
        assert module is not None
        executing = took(lambda module=module: execute(module, ALONE))
        run = execute(module, ALONE)
        judging = took(lambda run=run: judge(ALONE, run, None))
        found = simulated(source.text)
        saving = took(lambda found=found: saved_bytes(found))
        data = saved_bytes(found)
        loading = took(lambda data=data: load_run(data, "main.vrun"))
        print(
            f"  {count:6d} {kind:<10} compile {compiling:7.1f}  run {executing:7.1f}"
            f"  judge {judging:7.1f}  save {saving:7.1f}  load {loading:7.1f} ms"
        )
