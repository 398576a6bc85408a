"""Why a program is not sent, and who has answered for sending it all the same.

Each reason is a diagnostic with a code. A waiver is for one finding at one place: it names it as
the refusal does (`V812-3f2a9c`), with a person and a reason. When the finding is another, or its
figures are, the waiver covers it no more. It stands in the manifest and on the operator's sheet.
"""

import hashlib
import re
from collections.abc import Sequence
from dataclasses import replace
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


BREAK = "\n"
FINDING = re.compile(r"(V\d{3})-([0-9a-f]{6})")


class Promise(NamedTuple):
    """What somebody answers for."""

    finding: str  # "V812-3f2a9c"
    reason: str
    who: str


class Sorted(NamedTuple):
    """Refusals with and without a waiver."""

    refused: tuple[Diagnostic, ...]
    waived: tuple[Diagnostic, ...]
    waivers: tuple[Waiver, ...]
    idle: tuple[str, ...]  # waivers for which there was nothing to refuse


def place_of(refusal: Diagnostic) -> tuple[str, ...]:
    """Return code and place of a refusal: the step, its line, and what stands there."""
    label, data = refusal.primary, refusal.data
    at = ("", "") if label is None else (str(label.span.line), label.span.text)
    return (refusal.rule.code, str(data.get("program")), str(data.get("step")), *at)


def finding_of(refusal: Diagnostic) -> str:
    """Return the name of a refusal: the same as long as place and finding are the same."""
    parts = (*place_of(refusal), refusal.headline, *refusal.notes)
    return f"{refusal.rule.code}-{hashlib.sha256(BREAK.join(parts).encode()).hexdigest()[:6]}"


def sort_out(found: Sequence[Diagnostic], promises: Sequence[Promise]) -> Sorted:
    """Return which refusals stand and which are waived. A waiver covers the finding it names."""
    given = {promise.finding: promise for promise in promises}
    named = [(finding_of(d), d) for d in found]
    waived = [(name, d) for name, d in named if name in given and d.rule.code in WAIVABLE]
    covered = dict(waived)
    waivers = tuple(
        Waiver(d.rule.code, given[name].who, given[name].reason, (d.headline[:LONGEST],), name[-6:])
        for name, d in sorted(covered.items())
    )
    refused = tuple(_with_name(name, d) for name, d in named if name not in covered)
    idle = tuple(sorted(given.keys() - covered.keys()))
    return Sorted(refused, tuple(d for _, d in waived), waivers, idle)


def _with_name(name: str, refusal: Diagnostic) -> Diagnostic:
    """Return a refusal that says how to answer for it."""
    if refusal.rule.code not in WAIVABLE:
        return refusal
    answer = f'or answer for it: `--waive {name} --reason "..." --who NAME`'
    return replace(refusal, help=(*refusal.help, answer))


def promises_of(
    codes: Sequence[str], reasons: Sequence[str], people: Sequence[str]
) -> tuple[Promise, ...] | Diagnostic:
    """Return waivers as they were given: each with a reason and a name, or one name for all.

    Args:
        codes: What is waived, each as its refusal names it.
        reasons: As many.
        people: As many, or one.
    """
    people = tuple(people) * len(codes) if len(people) == 1 else tuple(people)
    if len(reasons) != len(codes) or len(people) != len(codes):
        said = f"{len(codes)} waivers, {len(reasons)} reasons and {len(people)} names"
        return _bad(said, 'give `--waive FINDING --reason "..."` for each, and `--who NAME`')
    for code, reason, who in zip(codes, reasons, people, strict=True):
        if code[:4] not in WAIVABLE:
            return _bad(f"`{code[:40]}` cannot be waived", f"what can be: {', '.join(WAIVABLE)}")
        if FINDING.fullmatch(code) is None:
            said = f"`{code[:40]}` says not which finding: a waiver is for one at one place"
            return _bad(said, "name it as the refusal does, like `V812-3f2a9c`: plan once without")
        if not reason.strip() or not who.strip():
            return _bad(f"nobody answers for the waiver of {code}", "give a reason and a name")
        if max(len(reason), len(who)) > 200:
            return _bad("a reason or a name has more than 200 characters", "write it shorter")
    if len(set(codes)) < len(codes):
        return _bad("a finding is waived twice", "one waiver is enough for it")
    rows = zip(codes, reasons, people, strict=True)
    return tuple(Promise(code, reason.strip(), who.strip()) for code, reason, who in rows)


def _bad(headline: str, remedy: str) -> Diagnostic:
    return error(BAD_WAIVER, headline, help=(remedy,))
