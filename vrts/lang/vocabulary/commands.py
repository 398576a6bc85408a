"""The commands of the monitor: what an operator types, not steps of programs.

See [manual language/monitor#commands].

The terminal of a command says how its operands are read:

* `NONE` takes none; `LIST` takes expressions and names between commas, some also behind `=`;
* `FILE` begins with the name of a file; `STEP` is carried out as the instruction of that name;
* `DO` is followed by an instruction; what follows a `REST` is not read.
"""

from vrts.lang.vocabulary.word import Match, Place, Word


def _c(
    text: str,
    form: str,
    usage: str,
    about: str,
    *,
    opaque: bool = False,
    shortest: str = "",
) -> Word:
    return Word(text, Place.COMMAND, "12+", form, usage, about, shortest=shortest, opaque=opaque)


_COMMANDS = (
    _c("ABORT", "NONE", "ABORT", "stop the program and the arm"),
    _c("BASE", "STEP", "BASE dx, dy, dz, rotation", "say how the robot was displaced"),
    _c("BPT", "REST", "BPT @program step", "set a breakpoint", opaque=True),
    _c("CALIBRATE", "NONE", "CALIBRATE", "calibrate the joints"),
    _c("COMPRESS", "REST", "COMPRESS", "compress a disk", opaque=True),
    _c("COPY", "LIST", "COPY new = old", "copy a program"),
    _c("CYCLE.END", "NONE", "CYCLE.END", "let the program end its cycle"),
    _c("DELETE", "LIST", "DELETE program", "delete a program and what only it uses"),
    _c("DELETEL", "LIST", "DELETEL location", "delete locations"),
    _c("DELETEP", "LIST", "DELETEP program", "delete programs"),
    _c("DELETER", "LIST", "DELETER variable", "delete numbers"),
    _c("DELETES", "LIST", "DELETES $variable", "delete strings"),
    _c("DIRECTORY", "LIST", "DIRECTORY program", "list the programs", shortest="DIR"),
    _c("DISABLE", "STEP", "DISABLE switch", "turn a switch off"),
    _c("DO", "DO", "DO instruction", "carry out one instruction"),
    _c("DPOINT", "LIST", "DPOINT location", "delete locations"),
    _c("EDIT", "LIST", "EDIT program, step", "edit a program"),
    _c("ENABLE", "STEP", "ENABLE switch", "turn a switch on"),
    _c("ERASE", "REST", "ERASE", "erase a disk", opaque=True),
    _c(
        "EXECUTE",
        "LIST",
        "EXECUTE program, cycles, step",
        "run a program",
        shortest="EX",
    ),
    _c("FCOPY", "FILE", "FCOPY new = old", "copy a file"),
    _c("FDELETE", "FILE", "FDELETE file", "delete a file"),
    _c("FDIRECTORY", "FILE", "FDIRECTORY", "list the files"),
    _c("FLIST", "FILE", "FLIST file", "show a file"),
    _c("FORMAT", "REST", "FORMAT", "format a disk", opaque=True),
    _c("FREE", "NONE", "FREE", "show the memory left"),
    _c("FRENAME", "FILE", "FRENAME new = old", "rename a file"),
    _c("HELP", "REST", "HELP word", "list the commands, or tell one word of the language"),
    _c("HERE", "LIST", "HERE location", "give a location the present pose", shortest="H"),
    _c("ID", "NONE", "ID", "show the version"),
    _c("INIT", "REST", "INIT", "begin a disk again", opaque=True),
    _c("IO", "LIST", "IO n", "show the signals"),
    _c("KILL", "NONE", "KILL", "clear a stopped program"),
    _c("LISTF", "FILE", "LISTF", "list the files"),
    _c("LISTL", "LIST", "LISTL location", "list locations"),
    _c("LISTP", "LIST", "LISTP program", "list programs"),
    _c("LISTR", "LIST", "LISTR expression", "list numbers"),
    _c("LISTS", "LIST", "LISTS $variable", "list strings"),
    _c("LOADL", "FILE", "LOADL file", "read locations"),
    _c("LOADP", "FILE", "LOADP file", "read programs"),
    _c("LOAD", "FILE", "LOAD file", "read a file"),
    _c("NEXT", "LIST", "NEXT n", "carry out some steps"),
    _c("PANIC", "NONE", "PANIC", "stop everything at once"),
    _c("PARAMETER", "LIST", "PARAMETER name = value", "show or set a parameter"),
    _c("PCABORT", "NONE", "PCABORT", "stop the process control program"),
    _c("PCEND", "LIST", "PCEND n", "let the process control program end"),
    _c("PCEXECUTE", "LIST", "PCEXECUTE program, cycles, step", "run a process control program"),
    _c("PCPROCEED", "NONE", "PCPROCEED", "go on with the process control program"),
    _c("PCRETRY", "NONE", "PCRETRY", "repeat the step of the process control program"),
    _c("PCSTATUS", "NONE", "PCSTATUS", "show the process control program"),
    _c("POINT", "LIST", "POINT location = value", "give a location a value"),
    _c("PRIME", "REST", "PRIME program", "make a program ready to run", opaque=True),
    _c("PROCEED", "NONE", "PROCEED", "go on with the next step"),
    _c("RENAME", "LIST", "RENAME new = old", "rename a program"),
    _c("RESET", "STEP", "RESET", "turn all outputs off"),
    _c("RETRY", "NONE", "RETRY", "repeat the step that failed"),
    _c("SIGNAL", "LIST", "SIGNAL number", "turn outputs on or off"),
    _c("SPEED", "LIST", "SPEED percent", "set the operator's speed"),
    _c("SSTEP", "LIST", "SSTEP", "carry out one step, calls whole"),
    _c("STATUS", "NONE", "STATUS", "show what is running"),
    _c("STORE", "FILE", "STORE file = program", "write programs and what they use"),
    _c("STOREL", "FILE", "STOREL file = program", "write locations"),
    _c("STOREP", "FILE", "STOREP file = program", "write programs"),
    _c("STORER", "FILE", "STORER file = program", "write numbers"),
    _c("STORES", "FILE", "STORES file = program", "write strings"),
    _c("SWITCH", "LIST", "SWITCH name", "list switches"),
    _c("TEACH", "LIST", "TEACH location", "record locations"),
    _c("TIME", "NONE", "TIME", "show the clock"),
    _c("TOOL", "STEP", "TOOL location", "say where the tool tip is"),
    _c("WATCH", "REST", "WATCH expression", "stop when a value changes", opaque=True),
    _c("WHERE", "LIST", "WHERE n", "show where the arm is"),
    _c("XSTEP", "LIST", "XSTEP", "carry out one step, into calls"),
    _c("ZERO", "NONE", "ZERO", "delete everything"),
)

COMMANDS = {word.text: word for word in _COMMANDS}

IDLE_ONLY = frozenset(  # refused while a program executes [manual language/monitor#idle]
    {
        *("BASE", "CALIBRATE", "DELETE", "DELETEL", "DELETEP", "DELETER", "DELETES", "DO"),
        *("DPOINT", "EXECUTE", "KILL", "NEXT", "PRIME", "PROCEED", "RENAME", "RETRY", "SSTEP"),
        *("TEACH", "TOOL", "XSTEP", "ZERO"),
    }
)


def look_up_command(text: str) -> Match:
    """Return the command a word stands for: an exact word, a fixed short form, a unique prefix."""
    text = text.upper()
    exact = COMMANDS.get(text)
    if exact is not None:
        return Match(exact)
    found = [word for word in _COMMANDS if word.text.startswith(text)]
    fixed = [word for word in found if word.shortest and text.startswith(word.shortest)]
    if fixed or len(found) == 1:
        return Match((fixed or found)[0])
    return Match(None, tuple(sorted(found, key=lambda word: word.text)))
