"""Source text to a module: the stages of the language in their order."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule
from vrts.base.pose import Pose
from vrts.base.source import SourceFile
from vrts.base.stack import deep_stack
from vrts.ir.module import Datum, Module, Program
from vrts.lang.dialect import VAL2, Dialect, Precedence
from vrts.lang.findings.flow import check_jumps, check_process_programs, check_reachable
from vrts.lang.findings.habits import check_habits
from vrts.lang.findings.names.elements import check_elements
from vrts.lang.findings.names.internal_signals import check_internal_signals
from vrts.lang.findings.remarks import check_remarks
from vrts.lang.findings.usage import check_usage
from vrts.lang.findings.values.check import ValueCheck
from vrts.lang.findings.ways.loops_left import LeavingCheck
from vrts.lang.findings.ways.reached import reached
from vrts.lang.findings.ways.recursion import CallCheck
from vrts.lang.joined import Joined
from vrts.lang.lowering.programs import Lowering
from vrts.lang.meaning.blocks.top_lines import check_declarations, check_groups
from vrts.lang.meaning.data_sections import read_data, report_replaced
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.scope import Scope, location_name
from vrts.lang.meaning.structure import Block, blocks, check_exits, labels
from vrts.lang.problems import Problems
from vrts.lang.reading.detection import detect
from vrts.lang.reading.headers import is_remarks, read_header
from vrts.lang.reading.pasted_characters import report_pasted_characters
from vrts.lang.reading.sections.lines import Section
from vrts.lang.reading.splitter import split
from vrts.lang.said_by_relatives import in_words_of
from vrts.lang.steps.step_parser import StepParser, names_in
from vrts.lang.syntax.program import Formal, ProgramText
from vrts.lang.syntax.statements import Bad
from vrts.lang.uncollected import uncollected

NOT_A_PROGRAM = Rule("V104", "not-a-program")
DUPLICATE_PROGRAM = Rule("V143", "duplicate-program")
NO_PROGRAM = Rule("V148", "no-program")

DATA_SUFFIXES = (".lc", ".rv", ".st")  # of files that STOREL, STORER and STORES write
_FEW = 3  # steps: fewer say nothing about what a file is


@dataclass(frozen=True, slots=True)
class Compilation:
    """What compiling a source yields."""

    module: Module | None  # None when there is any error
    diagnostics: tuple[Diagnostic, ...]  # in the order of the text
    dialect: Dialect = VAL2
    source: SourceFile | None = None  # what was compiled: one file, or several joined


class Resolved(NamedTuple):
    """Programs as syntax trees in which every name is known, and their data."""

    programs: list[ProgramText]
    sections: list[Section]  # those of the programs, in their order
    resolver: Resolver
    structures: dict[str, tuple[list[Block], dict[int | str, int]]]  # of each program
    data: list[Datum]
    stored: bool  # whether a file without programs is all right
    values: ValueCheck


class Options(NamedTuple):
    """How to read a program."""

    dialect: Dialect | None = None  # None: as file name and content tell
    precedence: Precedence | None = None  # None: as the dialect has it
    replace: bool = False  # a program that comes again takes the place of the first
    typed: bool = False  # at a controller, which takes any number and refuses it in a run


STRICT = Options(VAL2)


@deep_stack()
def compile_source(source: SourceFile, options: Options = STRICT) -> Compilation:
    """Compile a file: all problems in one go, one diagnostic a cause. Never raises."""
    dialect, found = options.dialect, None
    if dialect is None:
        dialect, found = detect(source)
    with uncollected():
        compilation = _compile(Problems(source, dialect), options)
    told = in_words_of(dialect, compilation.diagnostics)
    if told is not compilation.diagnostics:
        compilation = replace(compilation, diagnostics=told)
    if found is None or _told_as_error(found, compilation.diagnostics):
        return compilation
    return replace(compilation, diagnostics=(found, *compilation.diagnostics))


def _told_as_error(doubt: Diagnostic, found: Sequence[Diagnostic]) -> bool:
    """Whether an error says of a word that it is of another language, so that no doubt need."""
    if doubt.primary is None or doubt.data.get("dialect") != VAL2.name:
        return False
    start, end = doubt.primary.span.start, doubt.primary.span.end
    return any(
        d.is_error and d.primary is not None and start <= d.primary.span.start < end for d in found
    )


def compile_sources(sources: Sequence[SourceFile], options: Options = STRICT) -> Compilation:
    """Compile several files as one: programs call each other and share their data."""
    return compile_source(sources[0] if len(sources) == 1 else Joined(sources), options)


@deep_stack()
def resolve_source(source: SourceFile, dialect: Dialect) -> Resolved | None:
    """Return the syntax trees of a file that compiles; None for what is no program."""
    return _resolved(Problems(source, dialect), Options(dialect))


def _compile(problems: Problems, options: Options) -> Compilation:
    dialect = problems.dialect
    found = _resolved(problems, options)
    if found is None:
        return Compilation(None, tuple(problems.found), dialect, problems.source)
    if not found.programs and not found.stored and not problems.any_error:
        size = len(problems.source.text)
        problems.error(
            NO_PROGRAM,
            "this file holds no program",
            size,
            size,
            help=("begin one with `.PROGRAM name` and end it with `.END`",),
        )
    if problems.any_error:
        return Compilation(None, problems.in_order(), dialect, problems.source)
    lowered: dict[str, Program] = {}
    resolver = found.resolver
    alone = not found.values.beside
    for program in found.programs:
        structure = found.structures[program.name]
        lowering = Lowering(problems.source, resolver.scope, resolver, program, *structure)
        lowered[program.name] = lowering.run()
        reach = reached(program, lowered[program.name], structure[0])
        leaving = LeavingCheck(problems, program, lowered[program.name], reach)
        told = leaving.check(structure[0], alone=alone)
        check_reachable(problems, program, lowered[program.name], reach.instructions, told)
    CallCheck(problems, lowered).check(found.programs)
    found.values.followed(lowered)
    module = Module(MappingProxyType(lowered), _told_apart(found))
    return Compilation(module, problems.in_order(), dialect, problems.source)


def _told_apart(found: Resolved) -> tuple[Datum, ...]:
    """Return the data; locations that share names with numbers have names of their own."""
    entries = found.resolver.scope.entries
    shared = {entry.name for entry in entries.values() if entry.both}
    return tuple(
        datum._replace(name=location_name(datum.name))
        if datum.name in shared and isinstance(datum.value, Pose)
        else datum
        for datum in found.data
    )


def _resolved(problems: Problems, options: Options) -> Resolved | None:
    """Parse and resolve; None for a stranger, which is then all that is reported."""
    dialect = problems.dialect
    written = split(problems)
    sections = [s for s in written if not is_remarks(s, dialect)]
    headed = [s for s in sections if s.kind == "program"]
    headers: list[tuple[str, tuple[Formal, ...]]] = []
    unsound: set[int] = set()  # where the headers begin of which something was reported
    for section in headed:
        before = len(problems.found)
        headers.append(read_header(section, problems))
        if len(problems.found) > before:
            unsound.add(section.header.start)
    parser = StepParser(problems, options.precedence)
    parser.program_names = frozenset(name for name, _ in headers)
    programs: list[ProgramText] = []
    for section, (name, formals) in zip(headed, headers, strict=True):
        steps = tuple([parser.step(line) for line in section.lines])
        header = section.header
        programs.append(
            ProgramText(
                name,
                formals,
                steps,
                section.line_count,
                header.start,
                header.end,
                section.finish,
                header.start not in unsound,
            )
        )
    stranger = _stranger(problems, programs)
    if stranger is not None:
        problems.found[:] = [stranger]
        return None
    programs = _distinct(programs, problems, replace=options.replace)
    scope = Scope(programs)
    data: list[Datum] = []
    for section in sections:
        if section.kind != "program":
            data += read_data(section, parser, scope)
    report_pasted_characters(problems)
    parser.tolerated.report(problems)
    parser.report_block_steps()
    parser.let_go()
    report_replaced(problems, data)
    resolver = Resolver(problems, scope)
    for section in headed:
        left = not section.header.text and section.header.start not in {p.start for p in programs}
        if left or section.header.start in unsound:  # a formal of it may be any name in it
            resolver.bad_names.update(n for line in section.lines for n in names_in(line.text))
    structures: dict[str, tuple[list[Block], dict[int | str, int]]] = {}
    for program in programs:
        resolver.program = program.name
        for step in program.steps:
            if step.statement is not None:
                resolver.statement(step.statement)
        before = len(problems.found)
        found = blocks(program, problems)
        if len(problems.found) == before:
            check_exits(program, found, problems)
            check_groups(problems, program, found)
        check_declarations(problems, program)
        structures[program.name] = (found, labels(program, problems, programs))
        check_jumps(problems, program, *structures[program.name])
    parser.habits.report(problems)
    check_process_programs(problems, scope.programs)
    check_usage(resolver, programs)
    check_remarks(problems, scope, programs)
    values = ValueCheck(resolver, programs, refuses=not options.typed)
    values.written(data)
    blocks_of = {name: found for name, (found, _) in structures.items()}
    check_habits(problems, scope, programs, blocks_of, values.changed_by, alone=not values.beside)
    if not problems.any_error:
        check_elements(problems, scope, programs, blocks_of, data)
        check_internal_signals(problems, scope, programs)
    by_start = {section.header.start: section for section in headed}
    held = bool(data) or len(sections) < len(written)  # values, or remarks kept as a program
    stored = held and (dialect.is_as or problems.source.name.lower().endswith(DATA_SUFFIXES))
    kept = [by_start[program.start] for program in programs]
    return Resolved(programs, kept, resolver, structures, data, stored, values)


def _distinct(
    programs: list[ProgramText], problems: Problems, *, replace: bool
) -> list[ProgramText]:
    kept: dict[str, ProgramText] = {}
    for program in programs:
        if replace:
            kept[program.name] = program
            continue
        first = kept.setdefault(program.name, program)
        headed = first.start < first.end and program.start < program.end
        if not headed and program.start < program.end:
            kept[program.name] = program  # steps outside any program were reported
        if first is not program and program.name and headed:
            problems.error(
                DUPLICATE_PROGRAM,
                f"there are two programs `{program.name}`",
                program.start,
                program.end,
                secondary=(problems.label(first.start, first.end, "first here"),),
                notes=("VAL-II says *Program already exists*",),
                help=("give one of them another name, or compile with --replace",),
            )
    return list(kept.values())


def _stranger(problems: Problems, programs: list[ProgramText]) -> Diagnostic | None:
    """Return one diagnostic for a file that is something else altogether."""
    if any(p.start != p.end for p in programs):
        return None  # it has a header
    steps = [s.statement for p in programs for s in p.steps if s.statement is not None]
    bad = sum(isinstance(s, Bad) and s.word is None for s in steps)
    if len(steps) < _FEW or bad < 0.8 * len(steps):
        return None
    stranger = Problems(problems.source, problems.dialect)
    first = next(s for s in steps if isinstance(s, Bad))
    stranger.error(
        NOT_A_PROGRAM,
        f"`{problems.source.name}` is not a {problems.dialect.title} program",
        first.start,
        first.end,
        "this is not a step of a program",
        notes=(f"{bad} of {len(steps)} lines are not understood, and there is no .PROGRAM line",),
        help=("check that this is the right file",),
    )
    return stranger.found[0]
