"""HELP: what may be typed, and what a word of the language does.

No document says what HELP of a real controller printed: this is vrts's own.
"""

import textwrap
from difflib import get_close_matches

from vrts.ask.other_languages import own_words
from vrts.ask.words import facts
from vrts.ask.words import own_words as words_of_val2
from vrts.lang.typed.commands import CommandLine
from vrts.monitor import words
from vrts.monitor.desk import Desk, Refused, Situation, Turn

WIDTH = 78  # columns
GROUPS = {  # what an operator wants: commands, in the order in which they are needed
    "run and stop": "EXECUTE ABORT PROCEED RETRY NEXT SSTEP XSTEP CYCLE.END KILL PANIC DO SPEED",
    "see": "WHERE STATUS IO LISTL LISTR LISTS LISTP DIRECTORY SWITCH PARAMETER TIME FREE ID",
    "teach and set": "HERE TEACH POINT SIGNAL RESET ENABLE DISABLE TOOL BASE CALIBRATE",
    "programs": "EDIT COPY RENAME DELETE DELETEP DELETEL DELETER DELETES DPOINT ZERO",
    "files": (
        "LOAD LOADP LOADL STORE STOREP STOREL STORER STORES"
        " LISTF FLIST FDIRECTORY FCOPY FRENAME FDELETE"
    ),
    "second program": "PCEXECUTE PCSTATUS PCEND PCABORT PCPROCEED PCRETRY",
    "help": "HELP",
}
_BEGIN = "Commands, for example `EXECUTE main`; `HELP WHERE` tells one word, also of programs."


def help_with(line: CommandLine, desk: Desk, now: Situation) -> Turn:
    """HELP [word]."""
    wanted = line.rest.strip().strip("?\"'").upper()
    return Turn(_about(wanted) if wanted else _all())


def _all() -> str:
    width = max(map(len, GROUPS))
    rows = [_BEGIN]
    for group, commands in GROUPS.items():
        first = f"  {group:<{width}}  "
        rows += textwrap.wrap(
            commands,
            WIDTH,
            initial_indent=first,
            subsequent_indent=" " * len(first),
            break_on_hyphens=False,
        )
    return "".join(f"{row}\n" for row in rows)


def _about(wanted: str) -> str:
    """Return what is known of a word, or of those that VAL-II has for it."""
    known = facts()
    names = [wanted] if wanted in known else []
    if wanted not in words_of_val2():
        names += own_words().get(wanted.lower(), ())
    if not names:
        near = get_close_matches(wanted, known, 1)
        hint = f"did you mean `{near[0]}`?" if near else "`HELP` lists the commands"
        raise Refused(
            words.starred(words.UNDEFINED, f"`{wanted}` is no word of the language", hint)
        )
    told = "\n\n".join(fact.text for name in names for fact in known[name])
    return f"{told}\n"
