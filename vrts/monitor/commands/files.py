"""Commands on files: LOAD, STORE and their like, and those of the disk [manual language/files]."""

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile, Span
from vrts.ir.commands import Command, Load
from vrts.ir.module import Datum, Module
from vrts.ir.values import Type, Value, type_of_value
from vrts.lang.reading.decoding import decode
from vrts.lang.typed.commands import CommandLine, FileName
from vrts.lang.typed.entry import check_step, references
from vrts.lang.typed.loading import contents
from vrts.lang.writing.store import store_text
from vrts.monitor import words
from vrts.monitor.commands.questions import Sure
from vrts.monitor.desk import Desk, Refused, Situation, Turn, cell, program_name
from vrts.monitor.folder import CannotUse
from vrts.monitor.programs import StoredProgram, listed, reachable

_SUFFIX = {"P": ".pg", "L": ".lc", "R": ".rv", "S": ".st"}
_KINDS = {"L": (Type.POSE, Type.JOINTS), "R": (Type.REAL,), "S": (Type.STRING,), "P": ()}
_ALL = (Type.POSE, Type.JOINTS, Type.REAL, Type.STRING)
_SHOWN = 20  # problems of one file


def load(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """LOAD, LOADP, LOADL: programs and values; bad lines are kept, and shown."""
    kind = line.word.text.removeprefix("LOAD")
    name = file_name(line, _SUFFIX.get(kind, ".v2"))
    source = decode(desk.folder.read(name), name)
    if isinstance(source, Diagnostic):
        raise Refused(words.refusal(source))
    return load_source(source, desk, now, programs=kind != "L", data=kind != "P")


def load_source(
    source: SourceFile, desk: Desk, now: Situation, *, programs: bool = True, data: bool = True
) -> Turn:
    """Take what a file holds into memory."""
    found = contents(source, desk.dialect)
    rows = [_in_file(d) for d in found.diagnostics if d.is_error][:_SHOWN]
    commands: list[Command] = []
    if data:
        values, problems = _values(found.data, now)
        rows += problems
        if values:
            commands.append(Load(Module({}, values)))
    taken: list[str] = []
    for lines in found.programs if programs else ():
        known = desk.programs.get(lines.name)
        if known is not None and not desk.replace:
            rows.append(words.starred(words.PROGRAM_EXISTS, f"`{lines.name}` is kept as it is"))
        elif known is not None and now.occupies(lines.name):
            rows.append(words.starred(words.ILLEGAL_NOW, f"`{lines.name}` is being executed"))
        else:
            desk.programs[lines.name] = StoredProgram(lines.name, lines.header, lines.lines)
            taken.append(lines.name)
    for name in taken:  # when all are known: they may call each other
        installed = desk.install(desk.programs[name], now)
        commands += installed.commands
        rows += [f"{desk.programs[name].header}\n", installed.text]
        rows += problems_of(desk.programs[name], desk)
    return Turn("".join(rows), tuple(commands))


def problems_of(program: StoredProgram, desk: Desk) -> list[str]:
    """Return why a program is not executable: its bad lines, else the first fault."""
    rows: list[str] = []
    names = frozenset(desk.programs)
    for number in sorted(program.bad)[:_SHOWN]:
        found = check_step(program.lines[number - 1], desk.dialect, names)
        rows.append(listed(program, desk.dialect, [number]))
        rows.append(words.first_refusal(found) or "")
    if program.program is None and not program.bad and program.faults:
        first = program.faults[0]
        if first.primary is not None and first.primary.span.line > 1:
            rows.append(listed(program, desk.dialect, [first.primary.span.line - 1]))
        rows.append(words.refusal(first))
    return rows


def store(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """STORE, STOREP, STOREL, STORER, STORES: everything, or what programs need."""
    kind = line.word.text.removeprefix("STORE")
    name = file_name(line, _SUFFIX.get(kind, ".v2"))
    wanted = tuple(program_name(value) for value in line.values) if line.values else None
    text = stored_text(desk, now, kind, wanted)
    if not text:
        raise Refused(words.starred(words.UNDEFINED, "there is nothing to store"))

    def write(desk: Desk, now: Situation, *, replace: bool = True) -> Turn:
        try:
            desk.folder.write(name, text.encode(), replace=replace)
        except CannotUse as problem:
            return Turn(words.starred(problem.words, problem.reason))
        for program in wanted if wanted is not None else tuple(desk.programs):
            if kind in ("", "P") and program in desk.programs:
                desk.programs[program] = desk.programs[program]._replace(modified=False)
        return Turn()

    if desk.overwrite or not desk.folder.exists(name) or not desk.asks:
        return write(desk, now, replace=desk.overwrite)
    return Turn(words.starred(words.FILE_EXISTS), mode=Sure(write))


def stored_text(desk: Desk, now: Situation, kind: str, wanted: tuple[str, ...] | None) -> str:
    """Return what STORE writes: `kind` is empty, P, L, R or S; `wanted` are programs."""
    used: set[str] | None = None
    names = sorted(desk.programs)
    if wanted is not None:
        names, used = _reached(wanted, desk)
    programs = [desk.programs[name] for name in names] if kind in ("", "P") else []
    source = SourceFile("store.v2", "".join(program.text for program in programs))
    types = _KINDS.get(kind, _ALL)
    data = tuple(
        _datum(cell_name, value, source)
        for cell_name, value in now.state.variables.items()
        if type_of_value(value) in types and (used is None or cell_name.partition("[")[0] in used)
    )
    return store_text(source, Module({}, data), desk.dialect)


def _reached(wanted: tuple[str, ...], desk: Desk) -> tuple[list[str], set[str]]:
    """Return programs with all they call, and every variable that they name."""
    names = [desk.program(name).name for name in wanted]
    found = sorted(reachable(names, desk.programs, desk.dialect))
    used = [references(desk.programs[name].lines, desk.dialect).variables for name in found]
    return found, set[str]().union(*used)


def _datum(name: str, value: Value, source: SourceFile) -> Datum:
    base, _, index = name.rstrip("]").partition("[")
    indices = tuple(int(part) for part in index.split(",")) if index else ()
    return Datum(base, indices, value, Span(source, 0, 0))


def _values(data: tuple[Datum, ...], now: Situation) -> tuple[tuple[Datum, ...], list[str]]:
    """Return the values that fit what memory holds, and what is said of the others."""
    kinds = {n.partition("[")[0]: type_of_value(v) for n, v in now.state.variables.items()}
    fitting: list[Datum] = []
    rows: list[str] = []
    for datum in data:
        kind = type_of_value(datum.value)
        if kinds.setdefault(datum.name, kind) is kind:
            fitting.append(datum)
        else:
            name = cell(datum.name, datum.subscripts)
            rows.append(words.starred(words.MIXING, f"`{name}` is of another kind in memory"))
    return tuple(fitting), rows


def _in_file(found: Diagnostic) -> str:
    where = f"line {found.primary.span.line}: " if found.primary is not None else ""
    return words.starred(words.val_words(found) or "Illegal value", f"{where}{found.headline}")


# --- the disk -------------------------------------------------------------------------------------


def list_files(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """FDIRECTORY, LISTF: the files of the working folder, with their sizes."""
    return Turn("".join(f"{e.name:<24}{e.size:8d}\n" for e in desk.folder.entries()))


def show_file(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """FLIST: the text of a file."""
    name = file_name(line, ".v2")
    source = decode(desk.folder.read(name), name)
    if isinstance(source, Diagnostic):
        raise Refused(words.refusal(source))
    return Turn(source.text if source.text.endswith("\n") else f"{source.text}\n")


def delete_file(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """FDELETE: asks first."""
    name = file_name(line, ".v2")
    desk.folder.read(name)  # there is one

    def carry_out(desk: Desk, now: Situation) -> Turn:
        try:
            desk.folder.delete(name)
        except CannotUse as problem:
            return Turn(words.starred(problem.words, problem.reason))
        return Turn()

    return Turn(mode=Sure(carry_out)) if desk.asks else carry_out(desk, now)


def copy_file(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """FCOPY new = old."""
    new, old = _two_names(line)
    desk.folder.write(new, desk.folder.read(old), replace=False)
    return Turn()


def rename_file(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """FRENAME new = old."""
    new, old = _two_names(line)
    desk.folder.write(new, desk.folder.read(old), replace=False)
    desk.folder.delete(old)
    return Turn()


def file_name(line: CommandLine, suffix: str, *, second: bool = False) -> str:
    """Return the file that a command names, with the suffix of its kind where it has none."""
    operands = line.values if second else line.operands
    named = operands[0] if operands else None
    if not isinstance(named, FileName):
        raise Refused(words.starred(words.MISSING_ARGUMENT, f"write `{line.word.usage}`"))
    return named.text if "." in named.text else named.text + suffix


def _two_names(line: CommandLine) -> tuple[str, str]:
    return file_name(line, ".v2"), file_name(line, ".v2", second=True)
