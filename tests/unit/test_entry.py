"""Which program of a file is executed: the task's, else `main`, else the one that nobody calls."""

import re
from dataclasses import replace
from itertools import permutations
from pathlib import Path

import pytest

from tests.places import ROOT
from vrts.base.source import SourceFile
from vrts.debug.opening import Asked as Debugged
from vrts.debug.opening import opened
from vrts.ir.entry import Entry, Outline, entry_among
from vrts.lsp.answers.lenses import VERIFY, lenses
from vrts.lsp.channel.verification import Asked
from vrts.lsp.documents.documents import Document
from vrts.lsp.runs.verifying import verify
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.execution import executed
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task
from vrts.run_files.simulated import simulate

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
HELPER = '.PROGRAM helper()\n TYPE "helper"\n.END\n'


def outline(name: str, *calls: str, arguments: bool = False) -> Outline:
    return Outline(name, arguments, frozenset(calls))


@pytest.mark.parametrize(
    ("programs", "entry"),
    [
        ([], None),
        ([outline("a")], Entry("a")),
        ([outline("a"), outline("main", "a")], Entry("main")),
        ([outline("a", "main"), outline("main")], Entry("main")),
        ([outline("a"), outline("b", "a")], Entry("b")),
        ([outline("a", "a"), outline("b", "a")], Entry("b")),
        ([outline("a", "a")], Entry("a")),
        ([outline("a"), outline("b")], Entry("a", ("b",))),
        ([outline("c"), outline("b", "c"), outline("a", "c")], Entry("b", ("a",))),
        ([outline("a", "b"), outline("b", "a")], Entry("a", ("b",))),
        ([outline("a", arguments=True), outline("b")], Entry("b")),
        ([outline("main", arguments=True), outline("b", "main")], Entry("b")),
        ([outline("a", arguments=True)], Entry("a")),
    ],
)
def test_main_goes_before_the_one_that_nobody_calls(
    programs: list[Outline], entry: Entry | None
) -> None:
    assert entry_among(programs) == entry


def test_without_doubt_the_order_of_the_file_does_not_matter() -> None:
    programs = [outline("a", "b"), outline("b", "c"), outline("c", "c"), outline("d", "a", "c")]
    assert {entry_among(order) for order in permutations(programs)} == {Entry("d")}


def requested(text: str, task: Path | None = None) -> Request:
    setting = robot_alone() if task is None else load_task(task)
    return Request(ProgramFile(text.encode(), "two.v2"), setting)


def test_a_helper_above_main_costs_nothing() -> None:
    solution = (EXAMPLE / "solution.v2").read_text("utf-8")
    with_helper = assess(requested(HELPER + solution, EXAMPLE))
    assert with_helper.grade is not None
    assert float(with_helper.grade.mark) == 10.0
    programs, places = solution.split(".LOCATIONS")
    work, carry = programs.split(".PROGRAM carry")
    work = work.replace("main()", "work()")
    turned = f".PROGRAM carry{carry}{work}.LOCATIONS{places}"
    unnamed = assess(requested(turned, EXAMPLE))  # `carry` stands first, `work` calls it
    assert unnamed.grade is not None
    assert float(unnamed.grade.mark) == 10.0
    assert "V193" not in [d.rule.code for d in unnamed.diagnostics]


def test_the_program_of_the_task_goes_before_main() -> None:
    solution = (EXAMPLE / "solution.v2").read_text("utf-8")
    request = requested(HELPER + solution, EXAMPLE)
    assert request.setting.task is not None
    named = replace(request.setting, task=replace(request.setting.task, program="helper"))
    found = executed(request._replace(setting=named))
    assert found.run is not None
    assert found.run.output == "helper\r\n"


@pytest.mark.parametrize(
    "how",
    [
        "REACT 1001, b",
        "REACTI 1001, b",
        "PCEXECUTE b, 1",
        "CALL b",
    ],
)
def test_what_another_program_starts_is_called(how: str) -> None:
    text = f'.PROGRAM b\n TYPE "b"\n.END\n.PROGRAM a\n {how}\n TYPE "a"\n.END\n'
    found = simulate(requested(text))
    assert found.run is not None
    assert "a\r\n" in found.run.output
    assert [d.rule.code for d in found.diagnostics if d.rule.code == "V193"] == []


def test_two_that_may_be_meant_are_told(tmp_path: Path) -> None:
    text = '.PROGRAM two\n TYPE "two"\n.END\n.PROGRAM one\n TYPE "one"\n.END\n'
    request = requested(text)
    found = executed(request)
    assert found.run is not None
    assert found.run.output == "two\r\n"
    (said,) = [d for d in found.diagnostics if d.rule.code == "V193"]
    assert said.headline.startswith("nothing says which program to execute, so `two` is")
    assert said.primary is not None
    assert said.primary.span.line == 1
    assert [label.span.line for label in said.secondary] == [4]
    assert said.notes == ("none is called `main`, and these may be meant: `two`, `one`",)
    (tmp_path / "two.v2").write_text(text, "utf-8")
    debugged = opened(Debugged(tmp_path / "two.v2"))
    assert debugged.debugger is not None
    assert debugged.debugger.run.output == "two\r\n"
    assert "V193" in [d.rule.code for d in debugged.diagnostics]
    (named,) = executed(request._replace(entry="one")).diagnostics or (None,)
    assert named is None


@pytest.mark.parametrize(
    ("text", "entry"),
    [
        (".PROGRAM b\n.END\n.PROGRAM main\n CALL b\n.END\n", "main"),
        (".PROGRAM b\n.END\n.PROGRAM a\n CALL b\n.END\n", "a"),
        (".PROGRAM b\n.END\n.PROGRAM a\n.END\n", "b"),
        (".PROGRAM b(x)\n TYPE x\n.END\n.PROGRAM a\n CALL b(1)\n CALL a\n.END\n", "a"),
    ],
)
def test_editors_verify_the_same_one(text: str, entry: str) -> None:
    document = Document("/c/a.v2", text)
    asked = [lens.entry for lens in lenses(document) if lens.command == VERIFY]
    assert asked == re.findall(r"\.PROGRAM (\w+)\n", text)  # each that takes no arguments
    assert entry in asked
    found = executed(requested(text.replace("x\n", "/X0\n")))
    module = found.module
    assert module is not None
    assert module.main == entry


def test_editors_say_that_nothing_tells_which_one(tmp_path: Path) -> None:
    path = str(tmp_path / "a.v2")
    text = ".PROGRAM b\n READY\n.END\n.PROGRAM a\n READY\n.END\n"
    answer = verify(Asked(path, text))
    assert "V193" in [finding.code for finding in answer.findings]
    assert SourceFile(path, text).name == path
