"""Files of graders for tests, written as vrts writes them."""

import msgspec

from vrts.marking.by_hand.decisions.ledger import Ledger, ledger_of
from vrts.marking.by_hand.decisions.records import SCHEMA, Beginning, ChangeMark, Decision

AT = "2026-11-26T20:00:00+00:00"


def written(grader: str, *said: Decision) -> bytes:
    """Return a file of a grader; numbers are given in order."""
    numbered = [msgspec.structs.replace(one, number=k) for k, one in enumerate(said, 1)]
    lines = [msgspec.json.encode(one) for one in numbered]
    first = msgspec.json.encode(Beginning(SCHEMA, grader, grader.title()))
    return b"".join(line + b"\n" for line in (first, *lines))


def ledger(**files: tuple[Decision, ...]) -> Ledger:
    """Return the ledger of files, by grader."""
    found = ledger_of({f"{name}.jsonl": written(name, *said) for name, said in files.items()})
    assert not found.diagnostics
    return found


def change(*students: str, delta: str | None = None, mark: str | None = None) -> ChangeMark:
    """Return a change of a mark."""
    return ChangeMark(1, AT, students, "looked at", delta, mark)
