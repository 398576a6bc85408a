"""Futures as a tree: undo, redo, names, how many are kept."""

from pathlib import Path

from tests.unit.debug.scripted.test_commands import refused, said, session
from vrts.debug.branches.tree import MOST_KEPT
from vrts.debug.scripted.commander import carry_out


def test_each_change_is_a_branch_and_none_is_lost(tmp_path: Path) -> None:
    s = session(tmp_path)
    first = s.debugger.run
    carry_out(s, "to 5")
    said(s, "set n = 2")
    second = s.debugger.run
    said(s, "undo")
    assert s.debugger.run is first
    said(s, "set n = 1")
    said(s, "jump 7")
    said(s, "SPEED 50")
    lines = said(s, "branches").split("\n")
    assert [line.split(",")[-1].strip() for line in lines] == [
        ["1: the program as it was opened"][-1],
        "n = 2",
        "n = 1",
        "step 6 comes next",
        "speed 50 %",
    ]
    assert lines[-1].startswith("*")
    assert "future 2: value" in said(s, "branch 2")
    assert s.debugger.run is second
    assert "there are: 1, 2, 3, 4, 5" in refused(s, "branch 9")


def test_undo_and_redo_go_there_and_back(tmp_path: Path) -> None:
    s = session(tmp_path)
    assert "nothing to undo" in refused(s, "undo")
    assert "nothing was undone" in refused(s, "redo")
    carry_out(s, "to 5")
    said(s, "set n = 2")
    other = s.debugger.run
    carry_out(s, "at 3")
    said(s, "undo")
    assert s.debugger.at.time_s == 3.0
    said(s, "redo")
    assert s.debugger.run is other
    said(s, "undo")
    said(s, "set n = 3")
    assert "nothing was undone" in refused(s, "redo")  # there is another future now


def test_the_same_instant_is_stood_at_where_both_share_it(tmp_path: Path) -> None:
    s = session(tmp_path)
    carry_out(s, "at 3")
    said(s, "set n = 2")
    carry_out(s, "at begin")
    carry_out(s, "step")
    at = s.debugger.at
    said(s, "undo")
    assert s.debugger.at == at


def test_names_are_kept_and_no_two_are_alike(tmp_path: Path) -> None:
    s = session(tmp_path)
    carry_out(s, "to 5")
    said(s, "set n = 2")
    assert "called `two`" in said(s, "name two")
    said(s, "set n = 3")
    assert "another future" in refused(s, "name two")
    assert "begins with a letter" in refused(s, "name 7")
    last = [carry_out(s, f"set n = {k}").said[-1] for k in range(MOST_KEPT)][-1]
    assert "is not kept any more" in last
    assert len(s.debugger.tree.branches) == MOST_KEPT
    assert s.debugger.tree.called("two") is not None
    assert s.debugger.tree.called("1") is not None
    assert "future two" in said(s, "branch TWO")


def test_what_is_refused_makes_no_branch(tmp_path: Path) -> None:
    s = session(tmp_path)
    tree = s.debugger.tree
    assert refused(s, "set SIG(99999) = 1")
    assert refused(s, "set far = 3")
    assert s.debugger.tree is tree


def test_restart_keeps_the_futures(tmp_path: Path) -> None:
    s = session(tmp_path)
    carry_out(s, "to 5")
    said(s, "set n = 2")
    carry_out(s, "restart")
    assert s.debugger.tree.number == 1
    assert len(s.debugger.tree.branches) == 2
