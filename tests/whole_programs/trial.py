"""One program tried: executed, saved, loaded, executed again, cut, continued and forked.

What is no diagnostic is a fault of ours. Faults are collected, so that one does not hide others.
"""

import contextlib
import traceback
from collections import Counter
from collections.abc import Callable, Generator
from dataclasses import replace
from functools import cache
from pathlib import Path
from random import Random
from typing import NamedTuple

from tests.support_saved import answers, state_answers, with_scenario
from tests.whole_programs.drawing import Drawn, drawn
from tests.whole_programs.settings import setting
from vrts.base.source import SourceFile
from vrts.engine.controller import Controller, advance, execute, forked, start, truncate
from vrts.engine.machine import tick
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.ir.commands import Abort, Command, Execute, ForceSignals, MonitorSpeed, TimedCommand
from vrts.ir.instructions import Instruction
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.request import Request
from vrts.run_files import loading
from vrts.run_files.loading import check_again, load_run
from vrts.run_files.saving import saved_bytes
from vrts.run_files.simulated import Simulated, simulate
from vrts.scene.reading.scene_file import read_scene

TIMES = 2  # at which states are compared
LIMIT_CODES = {"V510", "V511", "V512", "V513"}
HOPELESS = {"V502", "V503", "V504"}
OPERATED: tuple[Command, ...] = (MonitorSpeed(40.0), ForceSignals((1001, -1002)), Abort())


class Looked(NamedTuple):
    """How much of a program is looked at beside executing, saving and loading it."""

    again: bool = True  # executed again as `--check` does
    cut: bool = True  # cut, continued, grown, forked, and all of it saved
    judged: bool = True  # executed without the judgement that ended it early


LIGHTLY = Looked(again=False, cut=False)


class Outcome(NamedTuple):
    """What a trial has found."""

    number: int
    faults: tuple[str, ...]  # of ours
    executed: Counter[type[Instruction]]  # kinds of instructions carried out
    endings: tuple[str, ...]  # codes of errors, or how the program ended
    hopeless: bool  # it was ended early
    unfinished: bool  # it went to a limit of the run


def trial(number: int, looked: Looked) -> Outcome:
    """Try the program of a number."""
    with _replaced(loading, "read_scene", _scene_read_once):
        return tried(drawn(number), looked)


def _scene_read_once(source: SourceFile, folder: Path | None, *, files: None = None) -> object:
    """Read a scene, which takes longer than all the rest, once for all files that tell it."""
    assert files is None, "no file of a run holds them"
    return _scene_of(source.name, source.text, folder)


@cache
def _scene_of(name: str, text: str, folder: Path | None) -> object:
    return read_scene(SourceFile(name, text), folder)


def tried(given: Drawn, looked: Looked) -> Outcome:
    """Try a program."""
    faults: list[str] = []
    found = Simulated(None, None, ())
    with _noting(faults, "executing"):
        found = simulate(_request(given))
    if found.run is None:
        told = [*faults, *(d.headline for d in found.diagnostics)]
        return Outcome(given.number, tuple(told), Counter(), (), False, False)
    run, draw = found.run, Random(given.number)
    with _noting(faults, "ordering strokes"):
        begun = [stroke.start_s for stroke in run.history.hand.strokes]
        assert begun == sorted(begun), "one of the hand begins before the last one"
    with _noting(faults, "saving and loading"):
        _same_when_saved(found)
    if looked.again:
        with _noting(faults, "executing again"):
            problem = check_again(load_run(saved_bytes(found), "out.vrun"))
            assert problem is None, problem.headline
    if looked.cut:
        for what in (_cut_and_continued, _grown_live, _other_future):
            with _noting(faults, what.__name__):
                what(found, draw)
    codes = [finding.rule.code for finding in run.findings if finding.is_error]
    if looked.judged and HOPELESS & set(codes):
        with _noting(faults, "judging"):
            _never_ends_unjudged(found)
    if any(finding.rule.code == "V505" for finding in run.findings):
        faults.append(f"not judged: {run.findings[-1].notes}")
    return Outcome(
        given.number,
        tuple(faults),
        _executed(run),
        tuple(codes) or (run.ending.value,),
        bool(HOPELESS & set(codes)),
        bool(LIMIT_CODES & set(codes)),
    )


def _request(given: Drawn) -> Request:
    place = with_scenario(setting(given.scene), given.scenario)
    return Request(ProgramFile(given.text.encode(), "main.v2"), place, Reading(given.dialect))


@contextlib.contextmanager
def _noting(faults: list[str], what: str) -> Generator[None]:
    """Note what is raised within."""
    try:
        yield
    except Exception as fault:  # whatever it is, it is a finding of the trial
        where = traceback.extract_tb(fault.__traceback__)[-1]
        told = getattr(fault, "diagnostics", None)
        words = told[0].headline if told else f"{fault!r:.300}"
        faults.append(f"{what}: {words} ({where.filename.split('/')[-1]}:{where.lineno})")


# --- what is looked at ----------------------------------------------------------------------------


def _same_when_saved(found: Simulated) -> None:
    """Check that a run and what is loaded of its file give the same answers."""
    run = found.run
    assert run is not None
    data = saved_bytes(found)
    read = load_run(data, "out.vrun")
    again = read.run
    assert again is not None
    assert saved_bytes(read) == data
    for one, other in zip(answers(run), answers(again), strict=True):
        assert one == other
    for k in range(TIMES + 1):
        time_s = min(run.horizon_s * k / TIMES, run.horizon_s)
        _alike(state_answers(run.at(time_s)), state_answers(again.at(time_s)))
        finished = run.statements * k // TIMES
        _alike(
            state_answers(run.at_statement(finished)), state_answers(again.at_statement(finished))
        )


def _alike(one: dict[str, object], other: dict[str, object]) -> None:
    differing = [name for name, value in one.items() if value != other[name]]
    assert not differing, differing


def _same_course(one: Run, other: Run) -> None:
    assert other.events == one.events
    assert list(other.motions) == list(one.motions)
    assert other.timeline.segments == one.timeline.segments
    assert (other.ending, other.ended_s) == (one.ending, one.ended_s)
    assert other.statements == one.statements
    assert other.at(other.horizon_s).variables == one.at(one.horizon_s).variables


def _cut_and_continued(found: Simulated, draw: Random) -> None:
    """Check that a run that was cut and continued is the run that was never cut."""
    run = found.run
    assert run is not None
    cut = truncate(run, draw.uniform(0.0, run.horizon_s))
    _same_when_saved(replaced(found, cut))
    _same_course(run, advance(cut, run.until_s, closed=True))


def _grown_live(found: Simulated, draw: Random) -> None:
    """Check that a run that grew in steps, under commands, is that which grew at once."""
    run = found.run
    assert run is not None
    assert run.module.main is not None
    until = draw.uniform(2.0, 9.0)
    told = [TimedCommand(0.0, Execute(run.module.main))]
    told += [TimedCommand(draw.uniform(0.1, until), draw.choice(OPERATED)) for _ in range(2)]
    told.sort(key=lambda timed: timed.time_s)
    begin = start(run.module, run.scene, run.scenario)
    whole = advance(begin, until, told)
    grown = begin
    for stop in sorted([*(draw.uniform(0.0, until) for _ in range(3)), until]):
        due = [timed for timed in told if timed.time_s <= stop]
        told = told[len(due) :]
        grown = advance(grown, stop, due)
    _same_course(whole, grown)
    _same_when_saved(replaced(found, grown))
    controller = Controller(run.module, run.scene, run.scenario)
    controller.issue(Execute(run.module.main), 0.0)
    _same_when_saved(replaced(found, controller.advance_until_stopped(20.0)))


def _other_future(found: Simulated, draw: Random) -> None:
    """Check that a fork can be made, saved, and leaves the first run as it was."""
    run = found.run
    assert run is not None
    before = answers(run)
    at = draw.uniform(0.0, run.horizon_s)
    other = forked(run, [TimedCommand(at, draw.choice(OPERATED))], run.until_s)
    _same_when_saved(replaced(found, other))
    assert answers(run) == before


def _never_ends_unjudged(found: Simulated) -> None:
    """Check that a program that is said never to end does not when it is let go on."""
    run = found.run
    assert run is not None
    longest = replace(run.scenario.limits, time_s=4.0 * run.scenario.limits.time_s)
    with _replaced(tick, "judge", lambda *_: None):
        alone = execute(run.module, run.scene, replace(run.scenario, limits=longest))
    codes = {finding.rule.code for finding in alone.findings if finding.is_error}
    assert alone.ending is Ending.LIMIT, alone.ending
    assert codes & (LIMIT_CODES | HOPELESS)


@contextlib.contextmanager
def _replaced(owner: object, name: str, value: Callable[..., object]) -> Generator[None]:
    kept = getattr(owner, name)
    setattr(owner, name, value)
    try:
        yield
    finally:
        setattr(owner, name, kept)


def replaced(found: Simulated, run: Run) -> Simulated:
    """Return what a file tells of another run of the same programs."""
    return Simulated(run, found.origin, run.findings)


def _executed(run: Run) -> Counter[type[Instruction]]:
    """Return how often each kind of instruction was carried out."""
    kinds = [
        type(instruction)
        for program in run.history.code.programs
        for instruction in program.instructions
    ]
    traces = (run.history.robot.trace, run.history.process.trace)
    return Counter(kinds[k] for trace in traces for k in trace.instructions)
