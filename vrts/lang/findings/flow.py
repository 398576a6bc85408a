"""Where the steps of a program lead: steps never reached, jumps into loops, the second program."""

from collections.abc import Iterator

from vrts.base.diagnostic import Rule
from vrts.ir import instructions as i
from vrts.ir.module import Program
from vrts.lang.meaning.structure import Block, label_key
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import (
    CallStatement,
    Device,
    Goto,
    HereStatement,
    ReactStatement,
    Rest,
    Setting,
    Simple,
    SpeedStatement,
    Statement,
)
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

UNREACHABLE = Rule("V223", "unreachable-step")
INTO_LOOP = Rule("V224", "jump-into-loop")
ROBOT_IN_PROCESS = Rule("V227", "robot-in-process")

_MARKS = (i.Jump, i.NextFor, i.TestFor, i.TestCase, i.Return)  # what END, ELSE, VALUE leave behind


def check_reachable(
    problems: Problems, text: ProgramText, program: Program, reached: set[int], told: set[int]
) -> None:
    """Warn of steps that no way through a program leads to, once for each stretch.

    `told` are instructions of which something else said so.
    """
    spans = {step.number: step.statement for step in text.steps}
    stretch: list[int] = []
    for at, (instruction, origin) in enumerate(
        zip(program.instructions, program.origins, strict=True)
    ):
        if at in reached or at in told:
            _report_stretch(problems, stretch, spans)
            stretch = []
        elif not isinstance(instruction, _MARKS) and origin.step in spans:
            stretch.append(origin.step)
    _report_stretch(problems, stretch, spans)


def _report_stretch(
    problems: Problems, steps: list[int], spans: dict[int, Statement | None]
) -> None:
    node = spans[steps[0]] if steps else None
    if node is None:
        return
    more = len(set(steps)) - 1
    problems.warning(
        UNREACHABLE,
        "this step is never reached",
        node.start,
        node.end,
        notes=(f"nor {'is' if more == 1 else 'are'} {more} more below it",) if more else (),
        help=("give it a label and jump to it, or take it out",),
        data={"steps": more + 1},
    )


def check_jumps(
    problems: Problems, program: ProgramText, found: list[Block], labels: dict[int | str, int]
) -> None:
    """Warn of a GOTO into a FOR loop from outside: its limits are not set."""
    loops = sorted((block for block in found if block.word == "FOR"), key=lambda b: b.opener)
    if not loops or not labels:
        return
    if not any(isinstance(step.statement, Goto) for step in program.steps):
        return
    place = {step.number: at for at, step in enumerate(program.steps)}
    around = _innermost(loops, len(program.steps))
    for at, step in enumerate(program.steps):
        node = step.statement
        if not isinstance(node, Goto) or label_key(node.label) not in labels:
            continue
        block = around[place[labels[label_key(node.label)]]]
        if block is None or block.opener < at < block.end:
            continue  # whoever is in the innermost loop is in all around it
        opener = program.steps[block.opener].statement
        assert opener is not None
        problems.warning(
            INTO_LOOP,
            "this jumps into a FOR loop",
            node.start,
            node.end,
            f"label {label_key(node.label)} is inside",
            secondary=(problems.label(opener.start, opener.end, "the loop begins here"),),
            notes=(
                "the end value of the loop is not set when its first line is passed by",
                "VAL-II says *Control structure error* at its END",
            ),
            help=("jump to a label before the FOR",),
        )


def _innermost(loops: list[Block], count: int) -> list[Block | None]:
    """Return the innermost loop around each step, its END included; loops in order."""
    around: list[Block | None] = [None] * count
    open_: list[Block] = []
    following = iter(loops)
    coming = next(following, None)
    for at in range(count):
        while open_ and open_[-1].end < at:
            open_.pop()
        around[at] = open_[-1] if open_ else None
        if coming is not None and coming.opener == at:
            open_.append(coming)
            coming = next(following, None)
    return around


def check_process_programs(problems: Problems, programs: dict[str, ProgramText]) -> None:
    """Warn of robot instructions in programs that PCEXECUTE starts, and in those they call."""
    started: dict[str, Name] = {}
    for program in programs.values():
        for step in program.steps:
            node = step.statement
            if isinstance(node, Simple) and node.word == "PCEXECUTE" and node.operands:
                first = node.operands[0]
                if isinstance(first, Name):
                    started.setdefault(key(first.text), first)
    waiting = list(started)
    why = dict(started)
    while waiting:
        name = waiting.pop()
        if name not in programs:
            continue
        for node in _statements(programs[name]):
            if isinstance(node, CallStatement) and key(node.program.text) not in why:
                why[key(node.program.text)] = why[name]
                waiting.append(key(node.program.text))
            word = _word_of(node)
            if word and INSTRUCTIONS[word].robot and word != "BRAKE":
                by = why[name]
                problems.warning(
                    ROBOT_IN_PROCESS,
                    f"{word} cannot stand in a process control program",
                    node.start,
                    node.end,
                    secondary=(problems.label(by.start, by.end, "started beside the robot here"),),
                    notes=("VAL-II says *Illegal in process control program*",),
                    help=(_instead(problems, node, word),),
                )
                break


def _instead(problems: Problems, node: Statement, word: str) -> str:
    """Return what to write in a process control program instead of a robot instruction."""
    if word == "DELAY" and isinstance(node, Simple) and node.operands and node.operands[0]:
        time = problems.source.text[node.operands[0].start : node.operands[0].end]
        return f"wait by a timer: `TIMER 2 = 0`, then `WAIT TIMER(2) > {time}`"
    return "signal to the robot program, and let it move the arm"


def _statements(program: ProgramText) -> Iterator[Statement]:
    return (step.statement for step in program.steps if step.statement is not None)


def _word_of(node: Statement) -> str | None:
    if isinstance(node, Simple | Setting | SpeedStatement | Device | Rest | ReactStatement):
        return node.word if node.word in INSTRUCTIONS else None
    return "HERE" if isinstance(node, HereStatement) else None
