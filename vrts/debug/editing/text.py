"""Another text taken up while it is debugged: compiled as before, and the run forked."""

from collections.abc import Mapping
from pathlib import Path

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.debug.console import Console
from vrts.debug.debugger import Debugger
from vrts.debug.editing.fork import Forked, edited
from vrts.debug.editing.lines import changed_lines, line_after
from vrts.debug.evaluating import CannotTell
from vrts.pipeline.compiling.programs import compile_bytes
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.execution import entry_in
from vrts.pipeline.files import CannotRead, read_bytes
from vrts.pipeline.request import Request

NO_TEXT = "a saved run goes on with no other text: debug the program itself"
MOST_BYTES = 4_000_000  # of a text that an editor sends


def take_up(console: Console, debugger: Debugger, sent: Mapping[str, str] | None = None) -> str:
    """Go on with other texts, from before the first step that differs; return what became of it.

    Args:
        console: Knows how the program was read; it has the new programs in memory then.
        debugger: Stands at the same instant then, or at the same time of the new future.
        sent: Texts by the names of their files; None: the files as they are now.

    Raises:
        CannotTell: The text cannot be taken up: everything is as it was.
    """
    request = console.request
    if request is None:
        raise CannotTell(NO_TEXT)
    request = _with_texts(request, debugger, sent)
    before = {source.name: source.text for source in sources_of(debugger)}
    found = compile_bytes(request.program.data, request.program.name, request.reading)
    module = None if found.compilation is None else found.compilation.module
    if module is None or found.compilation is None:
        raise CannotTell(_wrong(found.diagnostics))
    entry, said = entry_in(module, request)
    if entry is None:
        raise CannotTell(_wrong(said))
    after = {p.span.source.name: p.span.source.text for p in module.programs.values()}
    if after == before:
        raise CannotTell("the text is as it was")
    with debugger.memory.in_use():
        forked = edited(debugger.run, module, entry)
    at = debugger.at
    words = changed_lines(before, after)
    debugger.rewrite(forked.run, found.compilation.dialect, words, forked.differs)
    debugger.wishes.lines = [
        point._replace(line=line_after(before.get(point.source, ""), after[point.source], point[2]))
        if point.source in after
        else point
        for point in debugger.wishes.lines
    ]
    console.request = request
    files = console.files
    if files is not None:
        for name, text in after.items():
            files.taken(Path(name), text)
    console.show(sources_of(debugger))
    stays = forked.differs is None or at.finished <= forked.differs.finished
    told = _told(forked, stays=stays, time_s=debugger.at.time_s)
    return f"{words}: {told}"


def request_of(console: Console, debugger: Debugger) -> Request:
    """Return a request about the text of the present future.

    Raises:
        CannotTell: It is a saved run.
    """
    if console.request is None:
        raise CannotTell(NO_TEXT)
    return _with_texts(console.request, debugger, {})


def sources_of(debugger: Debugger) -> tuple[SourceFile, ...]:
    """Return the texts of the programs that the present run executes."""
    programs = debugger.run.module.programs.values()
    return tuple({p.span.source.name: p.span.source for p in programs}.values())


def _with_texts(request: Request, debugger: Debugger, sent: Mapping[str, str] | None) -> Request:
    """Return a request about the present texts, but for those that are other now."""
    present = {source.name: source.text for source in sources_of(debugger)}
    files = (request.program, *request.reading.others)
    strange = [name for name in sent or () if name not in {file.name for file in files}]
    if strange:
        raise CannotTell(f"`{Path(strange[0]).name}` is no text of this program")
    data: list[ProgramFile] = []
    for file in files:
        if sent is None:
            data.append(ProgramFile(_read(file.name), file.name))
        elif file.name in sent:
            data.append(ProgramFile(_limited(sent[file.name]), file.name))
        else:
            text = present.get(file.name)
            data.append(file if text is None else ProgramFile(text.encode(), file.name))
    reading = request.reading._replace(others=tuple(data[1:]))
    return request._replace(program=data[0], reading=reading)


def _read(name: str) -> bytes:
    try:
        return read_bytes(Path(name))
    except CannotRead as problem:
        raise CannotTell(f"{problem}: nothing has changed") from problem


def _limited(text: str) -> bytes:
    if len(text) > MOST_BYTES:
        raise CannotTell(f"a text has at most {MOST_BYTES:,} characters")
    return text.encode("utf-8", "replace")


def _wrong(diagnostics: tuple[Diagnostic, ...]) -> str:
    first = next((found for found in diagnostics if found.is_error), None)
    if first is None:
        return "there is no program to execute; nothing has changed"
    where = "" if first.primary is None else f"line {first.primary.span.line}: "
    return f"{where}{first.headline} ({first.rule.code}); nothing has changed"


def _told(forked: Forked, *, stays: bool, time_s: float) -> str:
    if forked.differs is None:
        said = ["nothing that was executed differs"]
    else:
        said = [f"the first step that differs comes at {forked.differs.time_s:.3f} s"]
    if not stays:
        said.append(f"you stand at {time_s:.3f} s of the new future")
    if forked.forgotten:
        many = len(forked.forgotten)
        made = "changes by hand later are" if many > 1 else "change by hand later is"
        said.append(f"{many} {made} not made again")
    return "; ".join(said)
