"""The constants that Hypothesis tries now and then: a fixed list, so that examples stay the same.

By itself Hypothesis takes them from the modules of a project that are loaded when an example is
drawn. With another order of tests those are other ones, and so are the examples, although they are
drawn without chance. `python -m tests.constants` makes the list of `tests/data/constants.json` anew
of what vrts holds now; all laws then have other examples.
"""

import json
from functools import cache
from pathlib import Path
from typing import cast

from hypothesis.internal import constants_ast
from hypothesis.internal.conjecture import providers
from hypothesis.internal.constants_ast import Constants

from tests.places import ROOT, TESTS

FILE = TESTS / "data" / "constants.json"
PRODUCT = ROOT / "vrts"


def fix() -> None:
    """Let Hypothesis draw from the list, and look at no module."""
    providers._get_local_constants = _fixed  # pyright: ignore[reportPrivateUsage]


@cache
def _fixed() -> Constants:
    """Return the list in an order of its own, when it is first asked for."""
    fixed = cast("Constants", vars(providers)["_local_constants"])
    for constant in read():
        fixed.add(constant)
    return fixed


def read() -> Constants:
    """Return the list."""
    kinds = json.loads(FILE.read_text(encoding="utf-8"))
    return Constants(
        integers=set(kinds["integers"]),
        floats=set(kinds["floats"]),
        bytes={bytes.fromhex(digits) for digits in kinds["bytes"]},
        strings=set(kinds["strings"]),
    )


def made(folder: Path = PRODUCT) -> Constants:
    """Return the constants of all modules below a folder, as Hypothesis finds them."""
    found = Constants()
    for path in sorted(folder.rglob("*.py")):
        found |= constants_ast._constants_from_source(  # pyright: ignore[reportPrivateUsage]
            path.read_bytes(), limit=True
        )
    return found


def main() -> None:
    """Make the list anew."""
    found = made()
    kinds = {
        "integers": sorted(found.integers),
        "floats": sorted(found.floats),
        "bytes": sorted(value.hex() for value in found.bytes),
        "strings": sorted(found.strings),
    }
    rows = (f"{json.dumps(kind)}: {json.dumps(values)}" for kind, values in kinds.items())
    FILE.write_text("{\n" + ",\n".join(rows) + "\n}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
