"""What functions gave is given again, where somebody says so, and nowhere else."""

from vrts.base.remembered import MOST, Memory, is_remembering, remembered


def test_nothing_is_remembered_unless_a_memory_is_in_use() -> None:
    made: list[int] = []

    def make() -> int:
        made.append(len(made))
        return made[-1]

    assert not is_remembering()
    assert [remembered("a", make), remembered("a", make)] == [0, 1]
    memory = Memory()
    with memory.in_use():
        assert is_remembering()
        assert [remembered("a", make), remembered("b", make), remembered("a", make)] == [2, 3, 2]
    assert remembered("a", make) == 4
    with memory.in_use():
        assert remembered("a", make) == 2
    with Memory().in_use():
        assert remembered("a", make) == 5


def test_what_is_not_worth_it_is_made_again_and_the_oldest_is_forgotten() -> None:
    memory = Memory()
    with memory.in_use():
        remembered("a", lambda: 1, worth=lambda _: False)
        assert remembered("a", lambda: 2) == 2
        for k in range(MOST):
            remembered(k, lambda: 0)
        assert remembered("a", lambda: 3) == 3
