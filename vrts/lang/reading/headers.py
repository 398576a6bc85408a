"""`.PROGRAM name(a, $b, c[])` to a name and formals. What is wrong is said here, and once.

Formals that are written otherwise are still read as far as they can be, so that calls fit.
"""

import re
from typing import NamedTuple

from vrts.base.diagnostic import Fix, Rule
from vrts.lang.dialect import Dialect
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.reading.sections.lines import Section
from vrts.lang.reading.sections.misplaced_lines import DEFAULT_PROGRAM
from vrts.lang.reading.splitter import INVALID_HEADER
from vrts.lang.syntax.expressions import Name
from vrts.lang.syntax.program import Formal

DUPLICATE_FORMAL = Rule("V217", "duplicate-formal")

_WORD = re.compile(r"\W{0,2}[ \t]*[A-Za-z]\w*[ \t]*", re.ASCII)  # .PROGRAM, also misspelt
_NAME = re.compile(r"[A-Za-z][\w.]*", re.ASCII)
_SIGNED = re.compile(
    r"""(?P<before>["'“”„‘’`$\#:=<\[{]+)[ \t]*(?P<name>[A-Za-z][\w.]*)["'“”‘’`>\]}]*""", re.ASCII
)
_GLUED = re.compile(r"\.PROGRAM(?P<name>[A-Za-z]\w*)$", re.IGNORECASE | re.ASCII)
_MORE_WORDS = re.compile(
    r"(?P<words>(?:[ \t]+[A-Za-z][\w.]*)+)[ \t]*(?:\([^()]*\)[ \t]*)?$", re.ASCII
)
_FORMALS = re.compile(r"[ \t]*(?P<open>[(\[{<])(?P<formals>[^()]*?)(?P<close>[)\]}>]?)[ \t]*$")
_ROUND = re.compile(r"[ \t]*\((?P<formals>[^()]*)\)")
_LOOSE = re.compile(r"(?P<comma>[ \t]*,)?[ \t]*(?P<formals>[$#]?[A-Za-z][\w.\[\]]*(?:[ \t]*,.*)?)$")
_AS_TAIL = re.compile(r"[@#\d]")  # date, time and number that AS writes behind the header
_PIECE = re.compile(r"[^,\[]*(?:\[[^\]]*\]?[^,\[]*)*")  # up to a comma that is not inside `a[,]`
_FORMAL = re.compile(
    r"(?P<name>(?:\.?&?|&?\.?)[$#]?[A-Za-z][\w.]*)[ \t]*(?P<array>\[[ ,]*\])?$", re.ASCII
)
_SIZED = re.compile(r"(?P<name>[$#]?[A-Za-z][\w.]*)[ \t]*[\[(][ \t\d,]*[\])]$", re.ASCII)
_WORDS = re.compile(r"[$#]?[A-Za-z][\w.]*(?:\[[ ,]*\])?", re.ASCII)
_DEFAULT = re.compile(r"(?P<piece>[^=]*[^=:\s])[ \t]*:?=[ \t]*[^=\s].*$")
_TYPES = re.compile(  # words of other languages for types and for ways to pass
    r"""REAL|REALS|INT|INTEGER|NUM|NUMBER|DOUBLE|FLOAT|SINGLE|LONG|BYTE|WORD|BOOL|BOOLEAN
    |CHAR|STR|STRING|TEXT|LOC|LOCATION|TRANS|TRANSFORM|TRANSFORMATION|POSE|POS|POSITION
    |POINT|ROBTARGET|JOINT|JOINTS|JOINTTARGET|FRAME|ARRAY|LIST|SIGNAL
    |VAR|VARIABLE|CONST|CONSTANT|LOCAL|AUTO|GLOBAL|PERS|DIM|LET
    |IN|OUT|INOUT|REF|BYREF|BYVAL|VAL|AS|OF""",
    re.IGNORECASE | re.VERBOSE,
)
_WRITE = "write `.PROGRAM name` or `.PROGRAM name(a, b)`"
_SAYS = "VAL-II says *Invalid program or variable name*"


class _Named(NamedTuple):
    name: str  # as written; empty where there is none
    end: int  # in the line


def read_header(section: Section, problems: Problems) -> tuple[str, tuple[Formal, ...]]:
    """Return name and formals of a program."""
    line = section.header
    if not line.text:
        return DEFAULT_PROGRAM, ()
    named = _name(section, problems)
    named = _joined(section, problems, named)
    formals: tuple[Formal, ...] = ()
    if named.end < len(line.text):
        formals = _formals(section, problems, named)
    return key(named.name) if named.name else "", formals


def _name(section: Section, problems: Problems) -> _Named:
    """Return the name, and report a missing or wrong one."""
    text, at = section.header.text, section.header.start
    word = _WORD.match(text)
    start = word.end() if word is not None else 0
    plain = _NAME.match(text, start)
    if plain is not None:
        return _Named(plain.group(), plain.end())
    rest = text[start:]
    signed = _SIGNED.match(text, start)
    glued = _GLUED.match(text)
    fix: Fix | None = None
    found = _Named("", len(text))
    where = (at, section.header.end)
    if signed is not None:
        found = _Named(signed["name"], signed.end())
        where = (at + start, at + signed.end())
        headline = f"the name of a program stands without `{signed['before'][0]}`"
        if signed["before"][0] in "\"'“”„‘’`":
            headline = "the name of a program stands without quotes"
        help_ = f"write `.PROGRAM {found.name}`"
        blank = " " if text[start - 1 : start].isalpha() else ""
        fix = problems.replace(*where, blank + found.name)
    elif glued is not None:
        found = _Named(glued["name"], len(text))
        headline, help_ = "a blank is missing before the name", f"write `.PROGRAM {found.name}`"
        fix = problems.replace(*where, f".PROGRAM {found.name}")
    elif re.match(r"[\d_.-]", rest):
        written = rest.split("(")[0].split()[0]
        where = (at + start, at + start + len(written))
        headline = f"`{written[:40]}` is not a name: a name begins with a letter"
        help_ = "write a name that begins with a letter, as in `.PROGRAM task1`"
    else:
        headline, help_ = "a program needs a name", _WRITE
    problems.error(INVALID_HEADER, headline, *where, notes=(_SAYS,), help=(help_,), fix=fix)
    return found


def _joined(section: Section, problems: Problems, named: _Named) -> _Named:
    """Report `pick part(a)`, a name of two or more words, and return it as one."""
    text, at = section.header.text, section.header.start
    more = _MORE_WORDS.match(text, named.end)
    if more is None or not named.name:
        return named
    words = [named.name, *more["words"].split()]
    behind = text[more.end("words") :].strip()
    if not behind and len(words) == len(("name", "argument")):
        return named  # it may be an argument, too
    start, end = named.end - len(named.name), more.end("words")
    name = ".".join(words)
    problems.error(
        INVALID_HEADER,
        "the name of a program is one word",
        at + start,
        at + end,
        help=(f"write `.PROGRAM {name}{behind}`: names have letters, digits, `.` and `_`",),
        fix=problems.replace(at + start, at + end, name, sure=bool(behind)),
    )
    return _Named(name, end)


def _formals(section: Section, problems: Problems, named: _Named) -> tuple[Formal, ...]:
    """Return the formals behind a name, and report what is neither."""
    text, at = section.header.text, section.header.start
    tail = text[named.end :]
    match = _ROUND.match(tail)
    rest = tail[match.end() :] if match is not None else tail
    odd: re.Match[str] | None = None
    if match is None and not _AS_TAIL.match(tail.strip()):
        odd = _FORMALS.match(tail) or _LOOSE.match(tail)
    formals: tuple[Formal, ...] = ()
    if match is not None:
        formals = _list(match["formals"], at + named.end + match.start("formals"), problems)
    if odd is not None:
        return _otherwise(section, problems, named, odd)
    rest = rest.strip()
    if rest and not _AS_TAIL.match(rest):
        start = section.header.end - len(rest)
        dash = re.match(r"-[ \t]*([A-Za-z][\w.]*)", rest)
        name = f"{named.name}_{dash.group(1)}" if dash is not None and match is None else ""
        end = start + (dash.end() if dash is not None and name else len(rest))
        removed = start if match is None else at + named.end + match.end()
        problems.error(
            INVALID_HEADER,
            f"`{rest[:40]}` does not belong to the name of a program",
            start,
            section.header.end,
            help=(f"write `.PROGRAM {name}`: names have letters, digits, `.` and `_`",)
            if name
            else (f"leave it out: {_WRITE}",),
            fix=problems.replace(at + text.index(named.name), end, name)
            if name
            else problems.replace(removed, section.header.end, ""),
        )
        return () if not name else formals
    return formals


def _otherwise(
    section: Section, problems: Problems, named: _Named, odd: re.Match[str]
) -> tuple[Formal, ...]:
    """Report formals that stand in no parentheses: `grip[s]`, `grip s, t`, `grip(s`."""
    line = section.header
    before = line.start + named.end
    sign = odd.groupdict().get("open")
    written = odd["formals"].strip()
    fitting = f"({written})"
    if sign is None and odd["comma"] is None and "," not in written:
        joined = f"{named.name}.{written}"
        problems.error(
            INVALID_HEADER,
            f"`{written[:40]}` does not belong to the name of a program",
            before + odd.start("formals"),
            line.end,
            "a name is one word",
            help=(
                f"if it belongs to the name, write `.PROGRAM {joined}`",
                f"if it is an argument, write `.PROGRAM {named.name}({written})`",
            ),
        )
        return ()
    comment = problems.source.text[line.end : line.end + 40].lstrip()[:1] == ";"
    if sign == "(" and comment:
        headline = "`(` is never closed: `;` begins a comment"
        help_ = "write commas between formal arguments, as in `(a, b)`"
    elif sign == "(":
        headline = "`(` is never closed"
        help_ = f"write `.PROGRAM {named.name}{fitting}`, with `)` at the end"
    elif sign is not None:
        headline = f"formal arguments stand in parentheses, not between `{sign}` and its partner"
        help_ = f"write `.PROGRAM {named.name}{fitting}`"
    else:
        headline = "formal arguments stand in parentheses"
        help_ = f"write `.PROGRAM {named.name}{fitting}`"
    problems.error(
        INVALID_HEADER,
        headline,
        before + odd.start() + len(odd.group()) - len(odd.group().lstrip()),
        line.end,
        help=(help_,),
        fix=None if comment else problems.replace(before, line.end, fitting),
    )
    quiet = Problems.none()
    return _list(odd["formals"], before + odd.start("formals"), quiet)


def _list(written: str, at: int, problems: Problems) -> tuple[Formal, ...]:
    """Return the formals between two parentheses; `at` is where they begin."""
    formals: list[Formal] = []
    taken: set[str] = set()
    for piece in _pieces(written):
        start = at + len(piece) - len(piece.lstrip())
        at += len(piece) + 1
        text = piece.strip()
        formal = _FORMAL.match(text)
        if formal is None and not text and "," not in written:
            continue
        array = bool(formal and formal["array"])
        name = formal["name"].replace("&", "") if formal else ""
        if formal is None and text:
            name, array = _odd_formal(text, start, problems)
        if name[:1] == "." and name[1] in "$#":
            name = f"{name[1]}.{name[2:]}"  # `.$s` of AS, with its sigil first
        if name and key(name) in taken:
            problems.error(
                DUPLICATE_FORMAL,
                f"`{name}` stands twice among the formals",
                start,
                start + len(name),
                help=("give each formal argument its own name",),
            )
            name = ""
        if name:
            taken.add(key(name))
        formals.append(Formal(Name(name, start, start + len(name)), array))
    return tuple(formals)


def _odd_formal(text: str, start: int, problems: Problems) -> tuple[str, bool]:
    """Report `REAL s`, `40`, `s = 1` or `v[10]` among formals; return what is meant as a name."""
    shown = text[:40]
    sized = _SIZED.match(text)
    default = _DEFAULT.match(text)
    words = _WORDS.findall(default["piece"] if default is not None else text)
    names = [word for word in words if _TYPES.fullmatch(word) is None]
    name = ""
    if sized is not None:
        name = sized["name"]
        headline = f"`{shown}`: a formal array stands without its size"
        help_ = f"write `{name}[]`"
    elif default is not None and len(names) == 1:
        name = names[0]
        headline = f"`{shown}`: a formal argument is a name, and has no default value"
        help_ = f"write only the name, `{name}`; CALL gives it its value"
    elif words and len(names) == 1 and len(words) > 1:
        name = names[0]
        headline = f"`{shown}` is not a formal argument: names are given no type"
        help_ = f"leave the type out, write only the name: `{name}`"
    elif len(words) > 1 and " ".join(words) == " ".join(text.split()):
        name = ", ".join(words)
        headline = f"`{shown}`: commas are missing between the formal arguments"
        help_ = f"write `{name}`"
    elif not words or text[:1] in "\"'":
        headline = f"`{shown}` is not a formal argument, but a value"
        help_ = "write a name such as `n` here: CALL gives it its value"
    elif text[0].isdecimal():
        headline = f"`{shown}` is not a formal argument"
        help_ = "names begin with a letter, as `n`, `$text`, `#point` or `row[]`"
    else:
        headline = f"`{shown}` is not a formal argument"
        help_ = "formals are names with commas between them, as `n`, `$text`, `#point` or `row[]`"
        name = names[0] if len(names) == 1 else ""
    array = sized is not None or (name.endswith("]") and "," not in name)
    name = name.partition("[")[0] if array else name
    fix = problems.replace(start, start + len(text), f"{name}[]" if array else name)
    problems.error(
        INVALID_HEADER,
        headline,
        start,
        start + len(text),
        help=(help_,),
        fix=fix if name else None,
    )
    return (name if "," not in name else ""), array


def _pieces(formals: str) -> list[str]:
    """Return what stands between the commas of a list of formals."""
    pieces: list[str] = []
    at = 0
    while at <= len(formals):
        match = _PIECE.match(formals, at)
        assert match is not None
        pieces.append(match.group())
        at = match.end() + 1
    return pieces


def is_remarks(section: Section, dialect: Dialect) -> bool:
    """Return whether a section is the fake program in which the editor of AS keeps its remarks."""
    if section.kind != "program" or not dialect.has("a"):
        return False
    word = _WORD.match(section.header.text)
    return word is not None and section.header.text[word.end() :].lower().startswith("comment___")
