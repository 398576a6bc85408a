"""The examples of run-time codes trigger them, run in the scene with the cans."""

import re
from importlib.resources import files

import pytest

from vrts.base.source import SourceFile
from vrts.check.limits import check_limits
from vrts.engine.controller import execute
from vrts.lang.compiler import compile_source
from vrts.pipeline import load_scene

PAGES = files("vrts").joinpath("pages")
EXAMPLE = re.compile(r"```val2\n(.*?)\n```", re.DOTALL)

# Examples that the compiler refuses already, and what motions planned today cannot do.
ELSEWHERE = {"V256", "V261", "V430"}


def examples() -> dict[str, str]:
    found: dict[str, str] = {}
    for page in PAGES.iterdir():
        code = page.name.removesuffix(".md")
        example = EXAMPLE.search(page.read_text("utf-8"))
        at_run_time = "V250" <= code < "V400" or "V500" <= code < "V600"
        if example and at_run_time and code not in ELSEWHERE:
            found[code] = example[1]
    return found


@pytest.mark.parametrize("code", sorted(examples()))
def test_example_triggers_the_code(code: str) -> None:
    compiled = compile_source(SourceFile("example.v2", examples()[code]))
    assert compiled.module is not None, compiled.diagnostics
    run = execute(compiled.module, load_scene("cans-on-bases").scene)
    found = [*run.findings, *check_limits(run).findings]
    assert code in {diagnostic.rule.code for diagnostic in found}
