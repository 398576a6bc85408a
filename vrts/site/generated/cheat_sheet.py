"""Two pages to print: VAL-II in short, by what one wants to do.

Forms and meanings are the vocabulary's.
"""

from typing import NamedTuple

from vrts.report.support import Entry, entries
from vrts.site.generated.markdown import block, code, container, text
from vrts.site.generated.word_pages import form


class Group(NamedTuple):
    """Words that belong together."""

    title: str
    words: str  # instructions, in the order of the page
    others: str = ""  # functions, operators, constants and commands, as `kind:word`


GROUPS = (
    Group(
        "Move", "MOVE MOVES APPRO APPROS DEPART DEPARTS DRAW DRIVE ALIGN MOVET MOVEST READY DELAY"
    ),
    Group("Stop, or stop nothing", "BREAK BRAKE COARSE FINE NULL NONULL INTON INTOFF"),
    Group("The hand", "OPEN OPENI CLOSE CLOSEI RELAX RELAXI GRASP", "function:HAND"),
    Group(
        "Speed and settings",
        "SPEED ENABLE DISABLE PARAMETER BASE TOOL",
        "qualifier:ALWAYS qualifier:MMPS qualifier:IPS function:SWITCH function:PARAMETER "
        "function:SPEED",
    ),
    Group("Which way the arm bends", "LEFTY RIGHTY ABOVE BELOW FLIP NOFLIP SINGLE MULTIPLE"),
    Group(
        "Locations",
        "SET HERE SHIFT",
        "function:TRANS function:SHIFT function:FRAME function:INVERSE function:NULL function:HERE "
        "function:#HERE function:DEST function:#DEST function:#PPOINT function:BASE function:TOOL "
        "function:RX function:RY function:RZ function:DX function:DY function:DZ "
        "function:DISTANCE function:IDENTICAL function:INRANGE function:DEFINED",
    ),
    Group(
        "Choose and repeat",
        "IF ELSE END FOR WHILE DO UNTIL CASE VALUE ANY GOTO",
    ),
    Group("Programs", "CALL RETURN STOP HALT PAUSE", "function:STATE function:STATUS"),
    Group(
        "Signals",
        "SIGNAL RESET WAIT BITS DAC",
        "function:SIG function:BITS function:ADC",
    ),
    Group(
        "React",
        "REACT REACTI REACTE IGNORE LOCK RETURNE",
        "function:ERROR function:$ERROR function:PENDANT",
    ),
    Group("A program beside the robot's", "PCEXECUTE PCEND PCABORT TIMER", "function:TIMER"),
    Group(
        "Numbers",
        "",
        "function:ABS function:INT function:FRACT function:SIGN function:SQR function:SQRT "
        "function:MAX function:MIN function:OUTSIDE function:RANDOM function:SIN function:COS "
        "function:TAN function:ATAN2 function:BCD function:DCB operator:MOD constant:PI",
    ),
    Group(
        "True and false",
        "",
        "operator:AND operator:OR operator:XOR operator:NOT operator:BAND operator:BOR "
        "operator:BXOR operator:COM constant:TRUE constant:FALSE constant:ON constant:OFF",
    ),
    Group(
        "Text",
        "TYPE PROMPT PACK",
        "function:$CHR function:ASC function:VAL function:$ENCODE function:LEN function:$MID "
        "function:POS function:$DECODE function:$UNPACK",
    ),
    Group(
        "At the monitor's dot",
        "",
        "command:EXECUTE command:ABORT command:PROCEED command:RETRY command:SPEED command:WHERE "
        "command:STATUS command:HERE command:TEACH command:POINT command:DO command:LOAD "
        "command:STORE command:EDIT command:DIRECTORY command:LISTP command:LISTL command:SIGNAL "
        "command:IO command:CALIBRATE",
    ),
)
PROGRAM = """\
.PROGRAM pick.and.place
        ; a can from one place to another
        SPEED 50 ALWAYS
        OPENI
        APPRO can, 100
        MOVES can
        CLOSEI
        DEPARTS 100
        APPRO place, 100
        MOVES place
        OPENI
        DEPARTS 100
.END
.LOCATIONS
; name  X Y Z in mm, then O A T in degrees
can     800 -450 -225 90 90 0
place   1100 230 -125 90 90 0
.END
"""
HEAD = """\
# VAL-II on two pages

:::{container} cheat-sheet-head
Print this page: it is made for both sides of a sheet of A4. Lower-case letters stand for what you
choose. [Words](words/index.md) says more of each.
:::

"""


def cheat_sheet() -> str:
    """Return the page."""
    known = {(entry.kind, entry.word): entry for entry in entries()}
    example = f"## A whole program\n\n{block('val2', PROGRAM)}"
    groups = "\n".join(_group(group, known) for group in GROUPS)
    return HEAD + container("cheat-sheet", f"{example}\n{groups}")


def members(group: Group) -> list[tuple[str, str]]:
    """Return kind and word of everything in a group."""
    others = (other.split(":") for other in group.others.split())
    instructions = [("instruction", word) for word in group.words.split()]
    return instructions + [(kind, word) for kind, word in others]


def _group(group: Group, known: dict[tuple[str, str], Entry]) -> str:
    rows = (known[member] for member in members(group))
    return f"## {group.title}\n\n" + "\n".join(
        f"{code(_form(entry))}\n: {text(_short(entry.about))}\n" for entry in rows
    )


def _form(entry: Entry) -> str:
    return entry.word if entry.kind in ("qualifier", "constant") else form(entry)


def _short(about: str) -> str:
    return about.replace(" in degrees", "").replace("program beside this one", "other program")
