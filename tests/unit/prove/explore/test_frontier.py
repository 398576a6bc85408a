"""The order in which futures are looked at."""

from dataclasses import replace

from tests.unit.prove.explore.proofs import ALONE, FREE, module_of
from vrts.engine.futures.future import tick
from vrts.prove.explore.frontier import LONG, Frontier, Future
from vrts.prove.explore.search import Search


def begun() -> Future:
    """Return a program that has come to its first question."""
    search = Search(module_of("n = 0\nWAIT SIG(1001)\nWAIT SIG(1002)\n"), ALONE, FREE)
    search.begin("main")
    future = search.frontier.pop()
    while tick(future.machine) is None:
        pass
    return future


def later(future: Future, cost: int, last_tick: int) -> Future:
    machine = future.machine.copy()
    machine.last_tick = last_tick
    return replace(future, machine=machine, cost=cost)


def elsewhere(future: Future) -> Future:
    """Return a future at another step."""
    machine = future.machine.copy()
    machine.robot.frames[-1].index += 1
    return replace(future, machine=machine)


def order(frontier: Frontier) -> list[Future]:
    return [frontier.pop() for _ in range(len(frontier))]


def test_the_fewest_decisions_go_first_then_the_earliest() -> None:
    first = begun()
    futures = [later(first, *one) for one in ((0, 3), (0, 9), (1, 2), (1, 4), (2, 1))]
    frontier = Frontier()
    for future in reversed(futures):
        frontier.push(future)
    assert frontier.is_earlier(futures[1])
    assert not frontier.is_earlier(futures[0])
    assert frontier.waiting() == futures
    assert order(frontier) == futures


def test_what_goes_on_for_long_waits_for_what_differs_little() -> None:
    first = begun()
    long, soon = later(first, 0, 2 * LONG), later(first, 1, 10)
    frontier = Frontier()
    frontier.push(long)
    frontier.push(soon)
    assert order(frontier) == [soon, long]


def test_where_the_fewest_states_were_goes_first_once_that_is_asked_for() -> None:
    often = later(begun(), 0, 1)
    seldom = elsewhere(later(often, 3, 5))
    frontier = Frontier()
    for _ in range(2):
        frontier.visits(often)
    frontier.visits(seldom)
    frontier.push(often)
    frontier.push(seldom)
    assert frontier.waiting() == [often, seldom]
    frontier.spread()
    assert frontier.waiting() == [seldom, often]
    assert frontier.is_earlier(often)
    frontier.visits(seldom)
    frontier.visits(seldom)
    frontier.push(frontier.pop())
    assert frontier.waiting() == [often, seldom]
