"""Which language of the family a file is written in, where nobody says.

The text as a whole decides: its words, headers, sections and signs. The end of its name only breaks
ties, since the same endings are used for several languages. What is close is read as VAL-II, and
both readings are said.
"""

from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.base.source import SourceFile
from vrts.lang.dialect import AS, VAL, VAL2, VPLUS, Dialect
from vrts.lang.joined import span_in
from vrts.lang.reading.evidence import DECLARING, Evidence, evidence

DIALECT_DETECTED = Rule("V157", "dialect-detected")

_CANDIDATES = (VAL2, VPLUS, AS, VAL)  # of equals, the first
_BY_SUFFIX = {".as": AS, ".lc": VAL2, ".rv": VAL2, ".st": VAL2}
_TIE = 1.0  # what the end of a name counts
_ENOUGH = 2.0  # by which another language must be better than VAL-II
_SLIP = 1.0  # one word of another language, which is said where it stands


class _Found(NamedTuple):
    """What speaks against each language, and what was looked at."""

    costs: dict[str, float]  # by name of the dialect
    seen: list[Evidence]


def detect(source: SourceFile) -> tuple[Dialect, Diagnostic | None]:
    """Return the dialect of a source, and a note where it is not VAL-II, or where it is close."""
    suffix = source.name[source.name.rfind(".") :].lower() if "." in source.name else ""
    named = _BY_SUFFIX.get(suffix)
    found = _weighed(source.text, named)
    best = min(_CANDIDATES, key=lambda dialect: found.costs[dialect.name])
    if best is VAL2:
        return VAL2, None
    own = _own(found.seen, best)
    ahead = found.costs[VAL2.name] - found.costs[best.name]
    if not own:
        if named is best:
            return best, _note(source, best, None, f"files that end in `{suffix}` are {best.title}")
        return VAL2, None
    if ahead < _ENOUGH and named is not best:
        own = [e for e in own if e.weight >= _SLIP]  # all of them tolerate empty parentheses
        return VAL2, _doubt(source, best, own) if own and ahead > _SLIP else None
    declared = own[0].what if all(e.what in DECLARING for e in own) else ""
    return best, _note(source, best, own[0], f"only {best.title} has {_listed(own)}", declared)


def _weighed(text: str, named: Dialect | None) -> _Found:
    seen = list(evidence(text))
    costs = {
        dialect.name: sum(e.weight for e in seen if not dialect.has(e.columns))
        - (_TIE if dialect is named else 0.0)
        for dialect in _CANDIDATES
    }
    return _Found(costs, seen)


def _own(seen: list[Evidence], dialect: Dialect) -> list[Evidence]:
    """Return what only a language has, or else what VAL-II lacks: one of each kind, in order."""
    only = [e for e in seen if e.columns == dialect.letters]
    lacking = only or [e for e in seen if dialect.has(e.columns) and not VAL2.has(e.columns)]
    kinds: dict[str, Evidence] = {}
    for e in sorted(lacking, key=lambda e: (e.weight < 1.0, e.start)):
        kinds.setdefault(e.what, e)
    return list(kinds.values())


def _listed(own: list[Evidence]) -> str:
    shown = [e.what for e in own[:3]]
    return " and ".join([", ".join(shown[:-1]), shown[-1]] if len(shown) > 1 else shown)


def _note(
    source: SourceFile, dialect: Dialect, at: Evidence | None, why: str, declared: str = ""
) -> Diagnostic:
    help_ = ["`--dialect val2` reads it as VAL-II"]
    if declared:
        help_.append(f"VAL-II declares no variables: for VAL-II leave the line with {declared} out")
    return Diagnostic(
        DIALECT_DETECTED,
        Severity.NOTE,
        f"this is read as {dialect.title}",
        Label(span_in(source, at.start, at.end), "") if at is not None else None,
        notes=(why,),
        help=tuple(help_),
        data={"dialect": dialect.name},
    )


def _doubt(source: SourceFile, other: Dialect, own: list[Evidence]) -> Diagnostic:
    return Diagnostic(
        DIALECT_DETECTED,
        Severity.NOTE,
        f"this is read as VAL-II, and may be {other.title}",
        Label(span_in(source, own[0].start, own[0].end), ""),
        notes=(f"only {other.title} has {_listed(own)}",),
        help=(f"`--dialect {other.name}` reads it as {other.title}, `--dialect val2` as VAL-II",),
        data={"dialect": VAL2.name},
    )
