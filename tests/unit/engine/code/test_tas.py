"""TAS tests and sets a variable in one step."""

from tests.support_engine import runs


def pc(lines_of_program: str) -> str:
    return f".PROGRAM watch\n{lines_of_program}\n.END\n"


def test_tas_is_one_step() -> None:
    """Of two programs that test and set in a loop, one at a time is inside."""
    enter = "WHILE TAS(lock, -1) <> 0 DO\nWAIT\nEND\ninside = inside+1\nmost = MAX(most, inside)\n"
    leave = "WAIT\ninside = inside-1\nlock = 0\n"
    run = runs(
        "lock = 0\ninside = 0\nmost = 0\nPCEXECUTE watch\nFOR i = 1 TO 20\n"
        + enter
        + leave
        + "END\nWAIT done\nTYPE most, inside",
        pc("done = 0\nFOR k = 1 TO 20\n" + enter + leave + "END\ndone = -1"),
        dialect="val2+",
    )
    assert run.output.split() == ["1", "0"]


def test_tas_returns_the_old_value_and_zero_at_first() -> None:
    run = runs("TYPE TAS(x, 3)\nTYPE TAS(x, 4)\nTYPE x", dialect="vplus")
    assert run.output.split() == ["0", "3", "4"]
