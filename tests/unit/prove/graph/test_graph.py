"""Graphs of states: what goes round for ever, and what waits for ever."""

from vrts.prove.graph.graph import AWAY, Graph, Visit


def graph(*states: tuple[int, bool], ways: dict[int, list[int]]) -> Graph:
    """Return a graph of states by their step and whether they wait there."""
    found = Graph()
    for k, (step, waits) in enumerate(states):
        found.add(Visit(None, k, 0, ((0, step),), waits, asks=False))
    for state, following in ways.items():
        for to in following:
            found.arrives(found.begin(state, None, 0), to, 0)
    return found


def test_a_cycle_without_a_way_out_is_closed() -> None:
    states = graph((0, False), (1, False), (2, False), ways={0: [1], 1: [2], 2: [1]})
    assert list(states.closed()) == [[1, 2]]


def test_a_cycle_with_a_way_out_is_not() -> None:
    ways = {0: [1], 1: [0, 2], 2: [AWAY]}
    states = graph((0, False), (1, False), (2, False), ways=ways)
    assert not list(states.closed())


def test_what_was_not_looked_at_may_lead_anywhere() -> None:
    states = graph((0, True), (1, True), ways={0: [1]})
    assert not list(states.closed())
    assert not list(states.staying())


def test_a_wait_from_which_nothing_leads_away_stays() -> None:
    ways = {0: [1, 2], 1: [1], 2: [2, 3], 3: [AWAY]}
    states = graph((0, False), (1, True), (2, True), (3, False), ways=ways)
    assert list(states.staying()) == [1]


def test_a_wait_that_comes_away_by_a_detour_does_not_stay() -> None:
    ways = {0: [1], 1: [0, 2], 2: [AWAY]}
    states = graph((5, True), (5, True), (6, False), ways=ways)
    assert not list(states.staying())
