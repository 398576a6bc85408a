"""Why a program is not sent, and who has answered for sending it all the same.

Each reason is a diagnostic with a code. A waiver names a code, a person and a reason; it stands in
the manifest and on the operator's sheet, with everything it covers.
"""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.dispatch.manifest import Waiver

NOT_PROVEN = Rule("V801", "not-proven")
UNDECIDED = Rule("V802", "not-decided")
NOT_TYPABLE = Rule("V803", "not-typable")
LINE_TOO_LONG = Rule("V804", "controller-line-length")
NAME_TOO_LONG = Rule("V805", "controller-name-length")
MEMORY_FULL = Rule("V806", "controller-memory")
WORD_MISSING = Rule("V807", "controller-lacks-word")
OTHER_LANGUAGE = Rule("V808", "controller-language")
LOST_BY_ROUNDING = Rule("V809", "lost-by-rounding")
NOT_EXECUTED = Rule("V810", "motion-not-executed")
NOT_COVERED = Rule("V811", "input-not-covered")
TOO_NEAR = Rule("V812", "clearance-too-small")
NO_MARGIN = Rule("V813", "margin-too-small")
BAD_WAIVER = Rule("V814", "bad-waiver")
FAILS_IN_A_FUTURE = Rule("V815", "fails-in-some-future")
NOT_ALL_FUTURES = Rule("V816", "not-all-futures")

LONGEST = 500  # characters of what a waiver covers, in the manifest

WAIVABLE = {
    rule.code: rule
    for rule in (
        NOT_PROVEN,
        UNDECIDED,
        LINE_TOO_LONG,
        NAME_TOO_LONG,
        MEMORY_FULL,
        WORD_MISSING,
        LOST_BY_ROUNDING,
        NOT_EXECUTED,
        NOT_COVERED,
        TOO_NEAR,
        NO_MARGIN,
        FAILS_IN_A_FUTURE,
        NOT_ALL_FUTURES,
    )
}  # the others leave nothing that could be sent


class Promise(NamedTuple):
    """What somebody answers for."""

    code: str
    reason: str
    who: str


class Sorted(NamedTuple):
    """Refusals with and without a waiver."""

    refused: tuple[Diagnostic, ...]
    waived: tuple[Diagnostic, ...]
    waivers: tuple[Waiver, ...]
    idle: tuple[str, ...]  # codes of waivers for which there was nothing to refuse


def sort_out(found: Sequence[Diagnostic], promises: Sequence[Promise]) -> Sorted:
    """Return which refusals stand and which are waived. A waiver covers all of its code."""
    given = {promise.code: promise for promise in promises if promise.code in WAIVABLE}
    waived = tuple(d for d in found if d.rule.code in given)
    by_code: dict[str, list[str]] = {}
    for diagnostic in waived:
        by_code.setdefault(diagnostic.rule.code, []).append(diagnostic.headline)
    waivers = tuple(
        Waiver(code, given[code].who, given[code].reason, tuple(h[:LONGEST] for h in headlines))
        for code, headlines in sorted(by_code.items())
    )
    refused = tuple(d for d in found if d.rule.code not in given)
    return Sorted(refused, waived, waivers, tuple(sorted(given.keys() - by_code.keys())))


def promises_of(
    codes: Sequence[str], reasons: Sequence[str], people: Sequence[str]
) -> tuple[Promise, ...] | Diagnostic:
    """Return waivers as they were given: each with a reason and a name, or one name for all.

    Args:
        codes: What is waived.
        reasons: As many.
        people: As many, or one.
    """
    people = tuple(people) * len(codes) if len(people) == 1 else tuple(people)
    if len(reasons) != len(codes) or len(people) != len(codes):
        said = f"{len(codes)} waivers, {len(reasons)} reasons and {len(people)} names"
        return _bad(said, 'give `--waive CODE --reason "..."` for each, and `--who NAME`')
    for code, reason, who in zip(codes, reasons, people, strict=True):
        if code not in WAIVABLE:
            return _bad(f"`{code}` cannot be waived", f"what can be: {', '.join(WAIVABLE)}")
        if not reason.strip() or not who.strip():
            return _bad(f"nobody answers for the waiver of {code}", "give a reason and a name")
        if max(len(reason), len(who)) > 200:
            return _bad("a reason or a name has more than 200 characters", "write it shorter")
    if len(set(codes)) < len(codes):
        return _bad("a code is waived twice", "one waiver covers all that is refused with its code")
    rows = zip(codes, reasons, people, strict=True)
    return tuple(Promise(code, reason.strip(), who.strip()) for code, reason, who in rows)


def _bad(headline: str, remedy: str) -> Diagnostic:
    return error(BAD_WAIVER, headline, help=(remedy,))
