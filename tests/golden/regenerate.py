"""Write the expected results anew: `python -m tests.golden.regenerate`. Read the difference!

Writes `expected.json` of every example, and the outputs shown in its tutorial. An output that
leaves something out (a line `…`) and still fits is kept as it is.
"""

from tests.golden.examples import EXAMPLES, mark, name, programs, text
from tests.golden.tutorial import rewritten


def main() -> None:
    """Write the files."""
    for example in EXAMPLES:
        rows = text((name(path), mark(path)) for path in programs(example))
        (example / "expected.json").write_text(rows, encoding="utf-8")
        readme = example / "README.md"
        changed = rewritten(readme.read_text(encoding="utf-8"), example)
        readme.write_text(changed, encoding="utf-8")


if __name__ == "__main__":
    main()
