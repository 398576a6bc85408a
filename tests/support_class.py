"""A class of submissions for benchmarks: variants of one program, some of which touch things."""

from collections.abc import Iterator
from typing import NamedTuple

from tests.places import TESTS
from vrts.marking.marking import Entry

FOLDER = TESTS / "data" / "forty-objects"
TASK = FOLDER / "task.toml"


class Lowered(NamedTuple):
    """A location that is taught too low, so that something touches."""

    name: str
    z_mm: str
    lowered: str


TOO_LOW = (
    Lowered("on_base1", "-165.00", "-168.00"),
    Lowered("on_base3", "-195.00", "-199.00"),
    Lowered("left", "-225.00", "-243.00"),
)


def entries(count: int) -> Iterator[Entry]:
    """Yield variants of the program of forty objects: no two alike, two of five with contacts."""
    text = (FOLDER / "solution.v2").read_text(encoding="utf-8")
    for k in range(count):
        yield Entry(f"s{k:03d}", f"s{k:03d}.v2", _variant(text, k).encode())


def _variant(text: str, k: int) -> str:
    changed = text.replace("BY 0,0,250", f"BY 0,0,{245 + 0.05 * (k % 200):.2f}")
    changed = f"; submission {k}\n" + changed.replace("DEPART 250", f"DEPART {240 + k % 11}")
    if k % 5 in (1, 3):
        low = TOO_LOW[k // 5 % len(TOO_LOW)]
        lines = [
            line.replace(low.z_mm, low.lowered) if line.startswith(low.name) else line
            for line in changed.split("\n")
        ]
        changed = "\n".join(lines)
    return changed
