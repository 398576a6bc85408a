"""The programs of a module as one program of URScript: a function each, in one that begins."""

from collections.abc import Mapping
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule
from vrts.base.pose import Pose
from vrts.base.units import MM
from vrts.dispatch.saying.arguments import Arguments
from vrts.dispatch.saying.calls import called_by
from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.names import plain, readable
from vrts.dispatch.saying.stretches import ends, jumps, numbered
from vrts.dispatch.saying.table import Table
from vrts.dispatch.saying.timers import timers
from vrts.dispatch.saying.under_way import MOTIONS as MOVES
from vrts.dispatch.saying.under_way import looks, tells_place, under_way
from vrts.dispatch.urscript.blocks import INDENT, Blocks, never_empty
from vrts.dispatch.urscript.jumps import go, jump_lines, kept
from vrts.dispatch.urscript.library import BEGINNING, CLOCK, FUNCTIONS, MOTIONS
from vrts.dispatch.urscript.processes import STATE, Processes, processes
from vrts.dispatch.urscript.steps import SILENT, Mode, Steps, asks
from vrts.dispatch.urscript.values import joints_text, name_of, number, pose_text
from vrts.dispatch.urscript.variables import EMPTY, variables
from vrts.dispatch.urscript.watching import THREADS, Watching, motions, watching
from vrts.ir import instructions as ir
from vrts.ir.module import Module, Program
from vrts.lang.compiler import Resolved
from vrts.lang.meaning.structure import word_of
from vrts.lang.syntax.program import ProgramText, Step

CANNOT = Rule("V877", "urscript-cannot")
MOVING = "the arm may still move when this looks at the outside or changes it"
REMEDY = "write BREAK before it: URScript goes on when a motion has ended"
QUIET = (ir.Assign, ir.Type, ir.SetSpeed, ir.Signal, ir.Reset, ir.SetTimer, *SILENT)


class Arm(NamedTuple):
    """What the text says of the arm."""

    X_FT: Pose
    ready: tuple[float, ...]
    joint_speed: float  # [rad/s] of the slowest joint
    linear_speed: float  # [m/s]
    acceleration_time: float  # [s]
    brake_time: float  # [s] from full speed
    hand_s: float


class Said(NamedTuple):
    """Programs in URScript, as far as they could be said."""

    text: str
    diagnostics: tuple[Diagnostic, ...]


def said(
    found: Resolved,
    module: Module,
    entry: str,
    table: Table,
    arm: Arm,
    radii: Mapping[tuple[str, int], float],
) -> Said:
    """Return the file of a program and all that it calls.

    Args:
        found: The programs as syntax trees.
        module: The same compiled.
        entry: The program that is executed.
        table: Inputs and outputs.
        arm: The arm.
        radii: Of rounded corners [m], by program and step.
    """
    try:
        watched, beside = watching(module, entry), processes(module, entry)
        if watched is not None and beside is not None:
            raise CannotSay("the program watches inputs and starts another one", "do one of both")
        names = called_by(module, entry)
        others = called_by(module, *(() if watched is None else watched.programs))
        others_beside = called_by(module, *(() if beside is None else beside.programs))
        held = variables(module)
    except CannotSay as cannot:
        return Said("", (cannot.diagnostic(CANNOT, module.programs[entry].span),))
    stops = watched is not None or _counts_joints(module)
    corners: Mapping[tuple[str, int], float] = {} if stops else radii
    begun = beside or watched
    writer = _Writer(found, module, table, arm, corners, begun, entry)
    texts = {program.name: program for program in found.programs}
    rows_beside: list[str] = []
    if beside is not None:
        mode = Mode(processes=beside, beside=True)
        rows_beside += STATE
        rows_beside += [row for name in others_beside for row in writer.program(texts[name], mode)]
        rows_beside += beside.threads()
    mode = Mode(watched, processes=beside)
    bodies = [row for name in names for row in writer.program(texts[name], mode)]
    mode = Mode(watched, reaction=True)
    between = [INDENT + row for name in others for row in writer.program(texts[name], mode)]
    rows = [
        f"def {plain(entry)}_of_val():",
        f"{INDENT}# Written by vrts; not tried on a controller. Read the sheet first.",
        *_library(module, arm, table, watched, held, between),
        f"{INDENT}set_tcp({pose_text(arm.X_FT)})",
        *_payload(table),
        f"{INDENT}global v_at = v_here()",
        *(INDENT + row for row in (*rows_beside, *bodies)),
        f"{INDENT}prog_{plain(entry)}()",
        "end",
    ]
    return Said("\n".join(rows) + "\n", tuple(writer.errors))


def _counts_joints(module: Module) -> bool:
    """Return whether a program turns joints from where they are: it has to stop before."""
    programs = module.programs.values()
    return any(isinstance(i, ir.Drive) for program in programs for i in program.instructions)


def _payload(table: Table) -> list[str]:
    """Return the line that tells what hangs on the flange, where the user's table says it."""
    if table.payload is None:
        return []
    centre = ", ".join(number(MM * part) for part in table.payload.centre_mm)
    return [f"{INDENT}set_payload({number(table.payload.mass_kg)}, [{centre}])"]


def _library(
    module: Module,
    arm: Arm,
    table: Table,
    watched: Watching | None,
    held: Mapping[str, str],
    between: list[str],
) -> list[str]:
    """Return what stands before the programs; the programs of reactions stand in it."""
    known = {
        "linear_mm": number(1000.0 * arm.linear_speed),
        "hand": number(arm.hand_s),
        "joint_a": number(arm.joint_speed / arm.acceleration_time),
        "joint_v": number(arm.joint_speed),
        "linear_a": number(arm.linear_speed / arm.acceleration_time),
        "linear_v": number(arm.linear_speed),
        "brake_a": number(arm.joint_speed / arm.brake_time),
        "hand_open": str(table.hand_open),
        "hand_close": str(table.hand_close),
    }
    clock = CLOCK.strip("\n").split("\n") if timers(module) else []
    begun = [BEGINNING, MOTIONS] if watched is None else [BEGINNING, THREADS]
    texts = "\n".join(text.strip("\n") for text in [*begun, FUNCTIONS])
    variables = (f"{INDENT}global {name} = {text}" for name, text in held.items())
    rows = [*texts.format(**known).split("\n"), *clock, *variables]
    if watched is None:
        return rows
    rows += [*watched.notes(table), *motions("r", "v_note"), *between]
    return [*rows, *watched.looks(), *motions("v", "v_look")]


class _Writer:
    def __init__(
        self,
        found: Resolved,
        module: Module,
        table: Table,
        arm: Arm,
        radii: Mapping[tuple[str, int], float],
        begun: Watching | Processes | None,
        entry: str,
    ) -> None:
        self.module, self.table, self.radii, self.begun = module, table, radii, begun
        self.resting = under_way(module, entry)
        programs = () if begun is None else begun.programs
        self.reacting = under_way(module, *programs)
        self.interrupted = under_way(module, *programs, moves=True)  # reactions begin so
        self.mode = Mode()
        self.problems = found.resolver.problems
        self.errors: list[Diagnostic] = []
        self.arm = arm
        self.arguments = Arguments(module)

    @property
    def moving(self) -> frozenset[tuple[str, int]]:
        """Where the arm may move, in the mode that is written now."""
        return self.reacting if self.mode.reaction or self.mode.beside else self.resting

    def program(self, text: ProgramText, mode: Mode) -> list[str]:
        """Return the lines of a program."""
        self.mode = mode
        program = self.module.programs[text.name]
        steps = Steps(self.table, joints_text(self.arm.ready), program, self.arguments, mode)
        names = ", ".join(name_of(formal) for formal in program.formals)
        rows = [f"def {mode.called}_{plain(text.name)}({names}):"]
        rows += [
            f"{INDENT}local {name_of(own)} = {EMPTY.get(own.type, '0')}" for own in program.autos
        ]
        if jumps(program, text):
            rows += [INDENT + row for row in self._by_numbers(program, text, steps)]
            return [*rows, "end"]
        rows += [INDENT + row for row in self._structured(program, text, steps)]
        return [*never_empty(rows), *(INDENT + row for row in steps.leaving), "end"]

    def _structured(self, program: Program, text: ProgramText, steps: Steps) -> list[str]:
        rows: list[str] = []
        blocks = Blocks(steps)
        straight = Straight()
        for step in text.steps:
            node = step.statement
            if node is None:
                continue
            depth, word = blocks.depth, word_of(step)
            at = _of_step(program, step)
            found = [program.instructions[k] for k in at]
            try:
                if word is not None:
                    straight.broken()
                    self._refuse_looks(program, at)
                    written = blocks.lines(word, found)
                else:
                    written: list[str] = []
                    for k in at:
                        written += self._lines(program, k, steps, rows, straight, blocks.depth)
            except CannotSay as cannot:
                self._cannot(cannot, step)
                blocks.pass_over(word or "", depth)
                continue
            indent = INDENT * min(depth, blocks.depth)
            straight.stands(found, len(rows))
            rows.append(self._comment(step, indent))
            rows += [indent + line for line in written]
        return rows

    def _by_numbers(self, program: Program, text: ProgramText, steps: Steps) -> list[str]:
        """Return a program that jumps: a loop that goes from one numbered part to the next."""
        by_number = {step.number: step for step in text.steps if step.statement is not None}
        parts_ = numbered(program)
        rows = ["# It jumps, so each stretch without jumps has a number.", *kept(program)]
        rows += ["local v_goto = 0", "while True:"]
        for here, (first, last) in enumerate(parts_):
            rows.append(f"{INDENT}{'el' if here else ''}if v_goto == {here}:")
            inner: list[str] = []
            straight = Straight()
            told = 0
            for k in range(first, last):
                step = by_number.get(program.origins[k].step)
                instruction = program.instructions[k]
                try:
                    jump = self._jump(program, k, steps, parts_)
                    if jump is None:
                        written = self._lines(program, k, steps, inner, straight, 0)
                    else:
                        straight.broken()
                        self._refuse_looks(program, [k])
                        written = jump
                except CannotSay as cannot:
                    if step is None:
                        raise
                    self._cannot(cannot, step)
                    continue
                straight.stands([instruction], len(inner))
                if step is not None and step.number != told:
                    inner.append(self._comment(step, ""))
                    told = step.number
                inner += written
            if not ends(program.instructions[last - 1]):
                inner += go(here + 1, here, steps.mode.passes)
            rows += [INDENT * 2 + row for row in inner]
        return [*rows, f"{INDENT}end", "end"]

    def _jump(
        self, program: Program, k: int, steps: Steps, parts_: list[tuple[int, int]]
    ) -> list[str] | None:
        here = next(n for n, (first, last) in enumerate(parts_) if first <= k < last)
        return jump_lines(program, k, steps, parts_, here)

    def _lines(
        self,
        program: Program,
        k: int,
        steps: Steps,
        rows: list[str],
        straight: "Straight",
        depth: int,
    ) -> list[str]:
        """Return what an instruction becomes; an output of a motion goes before it, into rows."""
        instruction = program.instructions[k]
        radius = self.radii.get((program.name, program.origins[k].step), 0.0)
        following = program.instructions[k + 1] if k + 1 < len(program.instructions) else None
        if (program.name, k) in self.moving and asks(instruction):
            if straight.motion is None:
                raise CannotSay(MOVING, REMEDY)
            written = steps.lines(instruction, following, radius)
            rows[straight.motion : straight.motion] = [INDENT * depth + row for row in written]
            straight.motion += len(written)
            return ["# stands before the motion that it begins with"]
        self._refuse_looks(program, [k])
        return steps.lines(instruction, following, radius)

    def _refuse_looks(self, program: Program, at: list[int]) -> None:
        for k in at:
            step = program.instructions[k]
            if (program.name, k) in self.moving:
                if looks(step):
                    raise CannotSay(MOVING, REMEDY)
                both = None
                apart = self.mode.reaction or self.mode.beside
                if self.begun is not None and not apart:
                    both = self.begun.shared.disturbs(step)
                if both is not None:
                    who = "a reaction" if isinstance(self.begun, Watching) else "the second program"
                    raise CannotSay(f"{who} knows `{both}`, and the arm may move", REMEDY)
            here = (program.name, k) in self.interrupted and tells_place(step)
            if (self.mode.reaction or self.mode.beside) and here:
                raise CannotSay("the arm may still move where HERE is read", "write BREAK first")

    def _comment(self, step: Step, indent: str) -> str:
        node = step.statement
        assert node is not None
        words = self.problems.source.text[node.start : node.end]
        return f"{indent}# {step.number:>3}  {readable(words)}"

    def _cannot(self, cannot: CannotSay, step: Step) -> None:
        node = step.statement
        assert node is not None
        found = cannot.diagnostic(CANNOT, self.problems.span(node.start, node.end))
        if found not in self.errors:  # a program may be written twice
            self.errors.append(found)


def _of_step(program: Program, step: Step) -> list[int]:
    last = len(program.instructions) - 1
    return [k for k, o in enumerate(program.origins) if o.step == step.number and k < last]


class Straight:
    """Where the last motion stands, while nothing but quiet steps came behind it."""

    def __init__(self) -> None:
        """Know of none."""
        self.motion: int | None = None  # row that its lines begin with

    def broken(self) -> None:
        """Forget it: the step may be reached in other ways too."""
        self.motion = None

    def stands(self, found: list[ir.Instruction], row: int) -> None:
        """Note where the lines of a step begin."""
        if any(isinstance(i, MOVES) for i in found):
            self.motion = row
        elif not all(isinstance(i, QUIET) for i in found):
            self.motion = None
