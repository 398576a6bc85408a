"""Threads, clocks and stops in the interpreter of URScript, as UR's manual has them."""

import numpy as np
import pytest

from tests.oracle.urscript.interpreter import Motion, Robot
from tests.oracle.urscript.values import NotTaken

STOPPED = (0.1, 0.0, 0.0, 0.0, 0.0, 0.0)
MOVE = "movej([1.0, 0.0, 0.0, 0.0, 0.0, 0.0])"


def robot(seconds: float = 1.0) -> Robot:
    """Return an arm whose motions take some seconds, and that stops within a tenth of one."""
    return Robot(
        lambda _: np.eye(4),
        (0.0,) * 6,
        lambda pin: pin == 0 and arm.now >= 0.3,
        lambda _: seconds,
        lambda _: (0.1, STOPPED),
    )


arm = robot()


def carried_out(text: str) -> Robot:
    """Return the arm after a program."""
    global arm
    arm = robot()
    rows = "\n".join(f"  {row}" for row in text.strip("\n").split("\n"))
    arm.run(f"def p():\n{rows}\nend\n")
    return arm


WATCHED = """
global busy = False
thread go():
  {move}
  global busy = False
end
busy = True
h = run go()
while busy:
  if get_standard_digital_in({pin}):
    kill h
    stopj(2.0)
    busy = False
  end
  sync()
end
textmsg("over")
"""


def test_a_motion_in_a_thread_is_killed_and_stopped_where_an_input_says_so() -> None:
    found = carried_out(WATCHED.format(move=MOVE, pin=0))
    kinds = [item.word if isinstance(item, Motion) else item[0] for item in found.done]
    assert kinds == ["movej", "stopj", "text"]
    assert found.when == pytest.approx([0.0, 0.3, 0.402])
    assert found.joints == STOPPED
    found = carried_out(WATCHED.format(move=MOVE, pin=1))
    assert found.when == pytest.approx([0.0, 1.002], abs=0.0021)
    assert found.joints is not None
    assert found.joints[0] == 1.0


def test_the_clock_goes_on_while_the_arm_moves_and_the_program_sleeps() -> None:
    found = carried_out(
        "t = time()\n"
        f"{MOVE}\nsleep(0.5)\nsync()\nu = time(0)\n"
        "textmsg((u.sec - t.sec) + (u.nanosec - t.nanosec) / 1000000000.0)"
    )
    assert found.done[-1][1] == pytest.approx(1.502)
    assert carried_out("textmsg(get_steptime())").done == [("text", 0.002)]


def test_join_waits_and_run_goes_on_first() -> None:
    text = 'thread a():\n  textmsg("a")\n  sleep(0.1)\nend\nh = run a()\ntextmsg("b")\njoin h\n'
    found = carried_out(text + 'textmsg("c")')
    assert [item[1] for item in found.done if item[0] == "text"] == ["b", "a", "c"]
    assert found.now == pytest.approx(0.1)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        (f"thread a():\n  {MOVE}\nend\nh = run a()\nsync()\n{MOVE}", "the arm is under way"),
        (f"thread a():\n  {MOVE}\nend\nh = run a()\nsync()\nkill h\n{MOVE}", "stops it before"),
        ("thread a():\n  sync()\nend\nh = run a()\nkill h\nkill h", "killed, once"),
        ("h = run b()", "there is no thread b"),
        ("thread a(x):\n  sync()\nend", "def NAME"),
        ("thread a():\n  x = y\nend\nh = run a()\nsync()\nsync()", "`y` has no value"),
        ("t = time()\ntextmsg(t.minutes)", "no member"),
        ("join 3", "no value|nothing may follow"),
    ],
)
def test_what_the_manual_does_not_have_is_not_taken(text: str, why: str) -> None:
    with pytest.raises(NotTaken, match=why):
        carried_out(text)


def test_halt_in_a_thread_ends_the_program() -> None:
    found = carried_out('thread a():\n  halt\nend\nh = run a()\nsync()\nsync()\ntextmsg("no")')
    assert found.done == []
