"""`[prove]` of a task: what it may say, and what it costs where it does not say."""

from fractions import Fraction

from vrts.base.source import SourceFile
from vrts.check.rules.proof_demand import USUAL_STATES
from vrts.check.task.task import Task
from vrts.check.task.task_file import read_task
from vrts.scene.default import robot_alone

TASK = """\
[task]
scene = "nowhere"

[time]
reference_s = 5

{mark}
[prove]
{keys}
"""


def read(keys: str = "", mark: str = "") -> tuple[Task | None, list[str]]:
    source = SourceFile("lab/task.toml", TASK.format(keys=keys, mark=mark))
    task, found = read_task(source, robot_alone())
    return task, [d.rule.code for d in found]


def test_alone_it_is_something_to_ask_for() -> None:
    task, codes = read()
    assert codes == []
    assert task is not None
    assert task.proof is not None
    assert (task.proof.points, task.proof.states) == (3, USUAL_STATES)
    assert (task.proof.environment, task.proof.inline, task.proof.hidden) == (None, False, False)
    assert [(cost.name, cost.points) for cost in task.costs] == [("every future", Fraction(3))]


def test_points_are_in_proportion_to_all_of_them() -> None:
    task, _ = read(mark="[mark]\ntotal = 20\n")
    assert task is not None
    assert task.proof is not None
    assert task.proof.points == 6


def test_it_says_what_it_costs_and_how_far_to_look() -> None:
    task, codes = read('environment = "cell.toml"\nstates = 500\npoints = 0.5\nhidden = true')
    assert codes == []
    assert task is not None
    assert task.proof is not None
    assert (task.proof.points, task.proof.states) == (Fraction(1, 2), 500)
    assert (task.proof.environment, task.proof.hidden) == ("cell.toml", True)


def test_an_environment_may_stand_in_it_and_is_not_read_here() -> None:
    task, codes = read("[[prove.environment.inputs]]\nsignal = 1001\nis = 'nonsense'")
    assert codes == []
    assert task is not None
    assert task.proof is not None
    assert task.proof.inline


def test_what_it_may_not_say_is_told() -> None:
    assert read("seconds = 5")[1] == ["V602"]
    assert read("states = 0")[1] == ["V605"]
    assert read("points = 11")[1] == ["V605"]
    assert read("environment = 5")[1] == ["V604"]
