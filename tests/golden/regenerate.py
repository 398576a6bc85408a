"""Write the expected results anew: `python -m tests.golden.regenerate`. Read the difference!

Writes `expected.json` of the first example, and the outputs shown in its tutorial. An output that
leaves something out (a line `…`) and still fits is kept as it is.
"""

from tests.golden.example_01 import EXPECTED, mark, name, programs, text
from tests.golden.tutorial import README, rewritten


def main() -> None:
    """Write the files."""
    EXPECTED.write_text(text((name(path), mark(path)) for path in programs()), encoding="utf-8")
    README.write_text(rewritten(README.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    main()
