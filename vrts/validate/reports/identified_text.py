"""What is wrong with a robot, as text: one sentence first, then the table."""

from collections.abc import Iterable, Sequence

from vrts.base.units import DEG, MM
from vrts.report.plain import one_line
from vrts.validate.identify.identified import Identified, Number, Remaining
from vrts.validate.identify.words import clause_of, decimals, name_of, unit_of

MOST_PAIRS = 6
OWN_RESTS = "the robot rests otherwise between motions: each was compared for itself"


def sentence(found: Identified) -> str:
    """Return what is wrong, in one sentence."""
    if not found.numbers:
        if found.fits:
            return "the log agrees with the run; nothing is off beyond noise"
        return (
            "this model does not fit the log, and no single cause explains it:"
            f" {_worst(found.remaining)}"
        )
    said = _listed([clause_of(number) for number in found.numbers])
    if found.fits:
        return f"{said}; nothing else is needed to explain the log"
    return f"{said}; but this does not fit the log: {_worst(found.remaining)}"


def identified_text(found: Identified) -> str:
    """Return the sentence, the table, what cannot be told, and what is left."""
    rows = [sentence(found), ""]
    if found.own_rests:
        rows += [OWN_RESTS, ""]
    if found.numbers:
        rows.append(f"  {'':34}{'off by':>12}   95 % between")
        rows += [_row(number) for number in found.numbers]
    rows.append(
        f"  {'clock at the start of the log [s]':34}{found.clock_s:+12.4f}"
        + ("" if found.own_rests else f"   ± {found.clock_half_s:.4f}")
    )
    rows += ["", *untold(found), "", *_left(found.remaining)]
    words = f"{found.rows} rows of {one_line(found.log)}"
    if found.synthetic:
        words += "; synthetic: made by a computer, not by a real robot"
    return "\n".join([*rows, "", words])


def _row(number: Number) -> str:
    unit = unit_of(number.cause.kind)
    digits = max(decimals(number.half / unit.size), 2)
    value, low, high = (v / unit.size + 0.0 for v in (number.value, number.low, number.high))
    return (
        f"  {f'{name_of(number.cause)} [{unit.name}]':34}{value:+12.{digits}f}"
        f"   {low:+.{digits}f} and {high:+.{digits}f}"
    )


def untold(found: Identified) -> list[str]:
    """Return what a log cannot tell, in sentences."""
    rows: list[str] = []
    for number in found.numbers:
        if number.alike:
            others = _listed([_listed([name_of(c) for c in group]) for group in number.alike], "or")
            rows.append(f"as well explained, instead of {name_of(number.cause)}, by {others}")
    for a, b in found.pairs[:MOST_PAIRS]:
        rows.append(f"{name_of(a)} and {name_of(b)} cannot be told apart in this log")
    if len(found.pairs) > MOST_PAIRS:
        rows.append(f"and {len(found.pairs) - MOST_PAIRS} other pairs")
    if found.silent:
        rows.append(f"the log says nothing of {_listed([name_of(c) for c in found.silent])}")
    if not any(r.joint for r in found.remaining):
        rows.append("the log has no joints: an encoder that counts wrong looks like a joint")
    elif all(r.joint for r in found.remaining):
        rows.append("the log has no positions: base, tool and the links of the arm are not seen")
    return rows


def _left(remaining: Sequence[Remaining]) -> list[str]:
    rows = [f"  {'left over, RMS':16}{'clock alone':>12}{'with causes':>13}{'pattern':>11}"]
    for r in remaining:
        unit = DEG if r.joint else MM
        name = f"{r.name} [{'deg' if r.joint else 'mm'}]"
        rows.append(
            f"  {name:16}{r.before / unit:12.4f}{r.after / unit:13.4f}{r.patterned / unit:11.4f}"
        )
    return rows


def _worst(remaining: Sequence[Remaining]) -> str:
    """Return the channel with the largest pattern for its noise."""
    r = max(remaining, key=lambda one: one.patterned / max(one.after, 1e-12))
    unit, name = (DEG, "degrees") if r.joint else (MM, "mm")
    return f"what is left of {r.name} has a pattern of {r.patterned / unit:.3f} {name}"


def _listed(words: Iterable[str], last: str = "and") -> str:
    each = list(words)
    if len(each) < 2:
        return "".join(each)
    return f"{', '.join(each[:-1])} {last} {each[-1]}"
