"""Mistakes that students make without knowing: now and then one, in what they wrote."""

from tests.support_judge.deciding import Mind
from tests.support_judge.source import Body, Free, Node, Source, Step, mapped, steps

SLIPS = {
    "none": 74.0, "never opens": 4.0, "low": 4.0, "no depart": 4.0, "half done": 4.0, "sign": 2.0,
    "slow": 3.0, "typo": 1.5, "comma": 0.7, "late close": 2.0, "twice": 1.0,
}  # fmt: skip


def with_slip(mind: Mind, source: Source) -> Source:
    """Return a program as it is handed in: most often as it was meant."""
    kind = mind.choose("slip", SLIPS)
    if kind == "none":
        return source
    if kind == "half done":
        return mapped(source, _half)
    if kind == "sign" or kind == "low":
        places = list(source.places)
        at = mind.rng.randrange(min(4, len(places)))
        x, y, z, *turn = places[at].values
        values = (
            (x, -y, z, *turn)
            if kind == "sign"
            else (x, y, z - mind.rng.choice((10, 15, 20, 25, 30)), *turn)
        )
        places[at] = places[at]._replace(values=values)
        return source._replace(places=tuple(places))
    return _once(mind, source, kind)


def _half(node: Node) -> Body:
    if isinstance(node, Free) and len(node.pieces) > 1 and _carries(node.pieces[-1]):
        return (Free(node.pieces[:-1]),)
    return (node,)


def _carries(body: Body) -> bool:
    return any(one.word in ("CALL", "CLOSEI") for one in steps(body))


def _once(mind: Mind, source: Source, kind: str) -> Source:
    """Change one step, the first of those that fit or a later one."""
    wanted = {
        "never opens": ("OPENI",), "no depart": ("DEPART", "DEPARTS"), "slow": ("SPEED",),
        "typo": ("MOVES",), "comma": ("APPRO",), "late close": ("CLOSEI",), "twice": ("APPRO",),
    }[kind]  # fmt: skip
    fits = sum(one.word in wanted for program in source.programs for one in steps(program.body))
    if fits == 0:
        return source
    chosen, seen = mind.rng.randrange(fits), 0

    def change(node: Node) -> Body:
        nonlocal seen
        if not isinstance(node, Step) or node.word not in wanted:
            return (node,)
        seen += 1
        return _slipped(node, kind) if seen == chosen + 1 else (node,)

    return mapped(source, change)


def _slipped(step: Step, kind: str) -> Body:
    match kind:
        case "slow":
            return (
                step._replace(operands=(step.operands[0].replace("100", "10").replace("80", "8"),)),
            )
        case "typo":
            return (step._replace(operands=(step.operands[0] + "s",)),)
        case "comma":
            return (step._replace(operands=(" ".join(step.operands),)),)
        case "late close":
            return (step._replace(word="CLOSE"),)
        case "twice":
            return (step, step)
        case _:
            return ()
