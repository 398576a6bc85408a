"""Commands on programs in memory: LISTP, DIRECTORY, COPY, RENAME, DELETE, ZERO.

See [manual language/monitor#programs].
"""

from collections.abc import Iterable

from vrts.ir.commands import Command, DeleteVariables, Kill
from vrts.lang.typed.commands import CommandLine
from vrts.lang.typed.entry import references
from vrts.monitor import words
from vrts.monitor.commands.questions import sure
from vrts.monitor.desk import Desk, Refused, Situation, Turn, program_name, stopped
from vrts.monitor.listings import directory_text
from vrts.monitor.programs import StoredProgram, listing, reachable


def list_programs(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """LISTP: programs with step numbers, all of them when none is named."""
    return Turn("".join(listing(program, desk.dialect) for program in _named(line, desk)))


def directory(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """DIRECTORY: names of programs, with `?` for those that are not executable."""
    rows = [(p.name, p.program is None, p.modified) for p in _named(line, desk)]
    return Turn(directory_text(rows))


def copy(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """COPY new = old."""
    new, old = _new_and_old(line, desk)
    return desk.install(_renamed(old, new), now)


def rename(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """RENAME new = old."""
    new, old = _new_and_old(line, desk)
    _refuse_in_use([old.name], desk, now)
    gone = desk.remove(old.name, now)
    return Turn(commands=(*gone, *desk.install(_renamed(old, new), now).commands))


def delete_programs(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """DELETEP: programs, and nothing else."""
    names = _free(line, desk, now)
    return sure(desk, now, lambda desk, now: Turn(commands=_removed(names, desk, now)))


def delete(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """DELETE: programs, with the programs and variables that nothing else refers to."""
    names = _free(line, desk, now)
    return sure(desk, now, lambda desk, now: _with_what_they_use(names, desk, now))


def zero(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """ZERO: every program and every variable."""
    return sure(desk, now, _zeroed)


def _zeroed(desk: Desk, now: Situation) -> Turn:
    kill = (Kill(),) if stopped(now.robot) else ()
    kept = reachable(stopped(now.state.process), desk.programs, desk.dialect)
    gone = tuple(name for name in desk.programs if name not in kept)
    commands = _removed(gone, desk, now)
    desk.last_edited = desk.last_executed = desk.last_process = desk.last_do = None
    variables = sorted({name.partition("[")[0] for name in now.state.variables})
    text = words.starred(words.IN_USE, f"kept: {', '.join(sorted(kept))}") if kept else ""
    return Turn(text, (*kill, *commands, *_forgotten(variables)))


def _with_what_they_use(names: tuple[str, ...], desk: Desk, now: Situation) -> Turn:
    used = {name: references(p.lines, desk.dialect) for name, p in desk.programs.items()}
    gone, kept = set(names), _resumable(desk, now)
    waiting = list(names)
    while waiting:
        for called in sorted(used[waiting.pop()].programs & desk.programs.keys() - gone):
            callers = {name for name, found in used.items() if called in found.programs}
            if callers <= gone | {called} and called not in kept:
                gone.add(called)
                waiting.append(called)
    others = {v for name, found in used.items() if name not in gone for v in found.variables}
    alone = {v for name in gone for v in used[name].variables} - others
    present = {name.partition("[")[0] for name in now.state.variables}
    commands = _removed(tuple(sorted(gone)), desk, now)
    return Turn(commands=(*commands, *_forgotten(sorted(alone & present))))


def _forgotten(variables: list[str]) -> tuple[Command, ...]:
    return (DeleteVariables(tuple(variables)),) if variables else ()


def _removed(names: tuple[str, ...], desk: Desk, now: Situation) -> tuple[Command, ...]:
    return tuple(command for name in names for command in desk.remove(name, now))


def _named(line: CommandLine, desk: Desk) -> list[StoredProgram]:
    if not line.operands:
        return [desk.programs[name] for name in sorted(desk.programs)]
    return [desk.program(program_name(operand)) for operand in line.operands]


def _free(line: CommandLine, desk: Desk, now: Situation) -> tuple[str, ...]:
    """Return the programs that are to be deleted; refuse for one that is being executed."""
    if not line.operands:
        raise Refused(words.starred(words.MISSING_ARGUMENT, f"write `{line.word.usage}`"))
    found = dict.fromkeys(program.name for program in _named(line, desk))
    _refuse_in_use(found, desk, now)
    return tuple(found)


def _refuse_in_use(names: Iterable[str], desk: Desk, now: Situation) -> None:
    kept = _resumable(desk, now)
    for name in names:
        if now.occupies(name):
            raise Refused(words.starred(words.ILLEGAL_NOW, f"`{name}` is being executed"))
        if name in kept:
            raise Refused(
                words.starred(
                    words.IN_USE,
                    f"`{name}` has stopped and may go on",
                    "let it come to its end, or clear it: KILL",
                )
            )


def _resumable(desk: Desk, now: Situation) -> set[str]:
    stopped_ones = stopped(now.robot) | stopped(now.state.process)
    return reachable(stopped_ones, desk.programs, desk.dialect)


def _new_and_old(line: CommandLine, desk: Desk) -> tuple[str, StoredProgram]:
    if len(line.operands) != 1 or line.values is None or len(line.values) != 1:
        raise Refused(words.starred(words.MISSING_ARGUMENT, f"write `{line.word.usage}`"))
    new = program_name(line.operands[0])
    old = desk.program(program_name(line.values[0]))
    if new in desk.programs:
        raise Refused(words.starred(words.PROGRAM_EXISTS, f"`{new}` is in memory"))
    return new, old


def _renamed(old: StoredProgram, new: str) -> StoredProgram:
    formals = old.header[old.header.find("(") :] if "(" in old.header else ""
    return old._replace(name=new, header=f".PROGRAM {new}{formals}", modified=True)
