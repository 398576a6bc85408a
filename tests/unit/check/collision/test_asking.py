"""Questions of two kinds asked together: each comes to its own result, in as few rounds as one."""

from collections.abc import Mapping

from vrts.check.collision.pairs.asking import Asking, both_told


def summed(*needs: int) -> Asking[int, int, int]:
    total = 0
    for need in needs:
        total += yield need
    return total


def named(*needs: int) -> Asking[int, int, str]:
    words: list[str] = []
    for need in needs:
        words.append(str((yield need)))
    return " ".join(words)


def test_both_kinds_come_to_their_own_in_rounds_that_they_share() -> None:
    rounds: list[Mapping[int, int]] = []

    def answer(needs: Mapping[int, int]) -> Mapping[int, int]:
        rounds.append(dict(needs))
        return {number: 10 * need for number, need in needs.items()}

    sums, names = both_told([summed(1, 2), summed()], [named(3), named(), named(4, 5, 6)], answer)
    assert sums == [30, 0]
    assert names == ["30", "", "40 50 60"]
    assert rounds == [{0: 1, 2: 3, 4: 4}, {0: 2, 4: 5}, {4: 6}]
