"""How many mutants there are, of which kinds, how large, and what they earn."""

from collections import Counter
from collections.abc import Callable, Iterable, Sequence

from tests.mutants.given import Mutant

BANDS = ((0.0, 0.0), (0.1, 2.4), (2.5, 4.9), (5.0, 7.4), (7.5, 9.9))  # of marks


def table(mutants: Sequence[Mutant]) -> str:
    """Return the table of mutants with one mistake and of those with two."""
    one = [mutant for mutant in mutants if len(mutant.kinds) == 1]
    two = [mutant for mutant in mutants if len(mutant.kinds) > 1]
    names = list(dict.fromkeys(mutant.original.name for mutant in mutants))
    head = f"{'one mistake':22}" + "".join(f"{name:>12}" for name in names) + f"{'all':>12}"
    lines = [head, _row("all", one, names)]
    kinds = Counter(mutant.kinds[0] for mutant in one)
    lines += (
        _row(f"  {kind}", [m for m in one if m.kinds[0] == kind], names)
        for kind, _ in kinds.most_common()
    )
    lines += ["", _row("two mistakes", two, names)]
    for title, some in (("one mistake", one), ("two mistakes", two)):
        lines += ["", f"{title}: sizes {_counted(some, lambda m: str(m.size))}"]
        lines.append(f"{title}: marks {_counted(some, _band)}")
    return "\n".join(lines)


def _row(title: str, mutants: Iterable[Mutant], names: list[str]) -> str:
    counts = Counter(mutant.original.name for mutant in mutants)
    cells = [*(counts[name] for name in names), counts.total()]
    return f"{title:22}" + "".join(f"{cell:12d}" for cell in cells)


def _counted(mutants: Iterable[Mutant], of: Callable[[Mutant], str]) -> str:
    counts = Counter(map(of, mutants))
    ordered = sorted(counts.items(), key=lambda item: float(item[0].split()[0]))
    return ", ".join(f"{name}: {number}" for name, number in ordered)


def _band(mutant: Mutant) -> str:
    low, high = next(band for band in BANDS if mutant.mark <= band[1])
    return f"{low:g} to {high:g}" if high else "0"
