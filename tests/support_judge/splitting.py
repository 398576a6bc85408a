"""A program cut into programs that it calls."""

from random import Random

from tests.support_judge.source import Body, Free, Loop, Node, Program, Source, Step, steps

CUTS = ("APPRO", "APPROS", "DEPART", "DEPARTS", "CLOSEI")  # a new program begins after one of these
NAMES = (
    "part_a",
    "teil2",
    "phase1",
    "go_on",
    "step_b",
    "half",
    "second",
    "sub_x",
    "inner",
    "round1",
)


def split(rng: Random, source: Source) -> Source:
    """Cut the longest program, and now and then the next, into programs that it calls."""
    out = source
    for _ in range(rng.choice((1, 1, 2))):
        longest = max(out.programs, key=lambda one: len(_flat(one.body)))
        if len(_flat(longest.body)) < 6:
            break
        taken = {one.name for one in out.programs}
        names = [name for name in rng.sample(NAMES, len(NAMES)) if name not in taken]
        body, pieces = _cut(rng, longest, names)
        programs: list[Program] = []
        for one in out.programs:
            programs += [one._replace(body=body), *pieces] if one is longest else [one]
        out = out._replace(programs=tuple(programs))
    return out


def _flat(body: Body) -> list[Node]:
    """Return a body without what says that its order is free."""
    out: list[Node] = []
    for node in body:
        out += (
            _flat(tuple(n for piece in node.pieces for n in piece))
            if isinstance(node, Free)
            else [node]
        )
    return out


def _cut(rng: Random, program: Program, names: list[str]) -> tuple[Body, list[Program]]:
    """Return what is left of a program, and the programs that its steps went to."""
    nodes = _flat(program.body)
    for at, node in enumerate(nodes):
        if isinstance(node, Loop) and len(_flat(node.body)) > len(nodes) // 2:
            inside = Program(names[0], (), node.body)
            nodes[at] = node._replace(body=(Step("CALL", (inside.name,)),))
            return tuple(nodes), [inside]
    after = [n for n, node in enumerate(nodes, 1) if isinstance(node, Step) and node.word in CUTS]
    after = [n for n in after if 2 < n < len(nodes) - 2] or [len(nodes) // 2]
    cuts = sorted(rng.sample(after, min(len(after), rng.choice((1, 2)))))
    pieces: list[Program] = []
    for name, begin, end in zip(names, [0, *cuts], [*cuts, len(nodes)], strict=False):
        piece = tuple(nodes[begin:end])
        read = {
            word for one in steps(piece) for operand in one.operands for word in operand.split(":")
        }
        used = tuple(one for one in program.parameters if one in read)
        pieces.append(Program(name, used, piece))
    return tuple(Step("CALL", (one.name, *one.parameters)) for one in pieces), pieces
