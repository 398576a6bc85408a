"""The page about every future: what is folded, where lines go, what stands on it."""

import json
import re
import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from tests.places import ROOT
from tests.support_commands import vrts_text
from tests.unit.report.page.futures_pages import DEEP, FOUND, WAITS, explored, on, proof
from vrts.cli.shared.options import Language
from vrts.cli.shared.programs import given_program
from vrts.cli.shared.requests import run_request
from vrts.pipeline.futures import leaf_replays, proved
from vrts.pipeline.where import Where
from vrts.prove.asking import Asking
from vrts.prove.environment.environment import Environment
from vrts.prove.proof import Branch
from vrts.report.page.futures import whole
from vrts.report.page.futures.drawing import tree
from vrts.report.page.futures.folding import MOST, Mark, nodes, scenarios_of
from vrts.report.page.futures.lanes import lanes
from vrts.report.page.futures.whole import futures_page

SVG = re.compile(r"<svg .*?</svg>", re.DOTALL)


def test_a_wait_of_many_ticks_is_one_line_with_a_number() -> None:
    root, first, others = nodes(WAITS)
    assert (root.parent, root.decided, root.many) == (None, None, 1)
    assert (first.parent, first.ends, first.many) == (0, "completed", 1)
    assert (others.parent, others.many, others.into) == (0, 99, 1)
    assert (round(others.start_s, 3), round(others.last_s, 3)) == (0.528, 3.272)
    assert others.is_merged
    assert root.end_s == others.last_s, "it goes on until the last of them parts"


def test_what_goes_on_differently_is_not_folded() -> None:
    other = (Branch(0, on(5.0 + k), "completed" if k % 2 else "error", 9.0) for k in range(2))
    found = nodes(replace(WAITS, tree=(*WAITS.tree, *other)))
    assert [(one.many, one.ends) for one in found[1:]] == [
        (1, "completed"),
        (99, "merged"),
        (1, "error"),
        (1, "completed"),
    ]


def test_a_tree_that_is_too_large_is_cut_and_says_how_much_is_left() -> None:
    found = nodes(DEEP)
    assert len(found) == MOST
    assert [one.left for one in found if one.left] == [601 - MOST]
    assert "+301" in tree(found)


def test_what_goes_wrong_stands_at_its_future_and_is_never_left_out() -> None:
    found = nodes(FOUND, most=1)
    marks = [(k, mark) for k, one in enumerate(found) for mark in one.marks]
    assert marks == [(0, Mark(2, 3.5)), (3, Mark(1, 3.5))]
    chain = [found[3]]
    while (parent := chain[-1].parent) is not None:
        chain.append(found[parent])
    assert [one.decided for one in reversed(chain)][1:] == list(FOUND.found[0].decisions)
    assert len(nodes(FOUND)) == 5, "what was explored is not drawn twice"


def test_a_future_that_nobody_followed_is_open() -> None:
    assert [one.ends for one in nodes(proof(Branch(None, None, ""), Branch(0, on(1.0), "")))] == [
        "",
        "open",
    ]


def test_no_line_crosses_another() -> None:
    found = nodes(replace(WAITS, tree=(*WAITS.tree, Branch(5, on(1.5, 1002), "completed", 2.0))))
    rows = lanes(found)
    assert sorted(rows) == list(range(len(found)))
    for k, one in enumerate(found):
        if one.parent is None:
            continue
        between = range(rows[one.parent] + 1, rows[k])
        crossed = [
            other
            for n, other in enumerate(found)
            if rows[n] in between and other.start_s < one.start_s < other.end_s
        ]
        assert crossed == []


def test_the_picture_is_sound_and_the_same_each_time() -> None:
    picture = tree(nodes(FOUND))
    root = ET.fromstring(picture)
    chosen = list(root.iter("a"))
    assert sorted(one.get("id", "") for one in chosen) == [f"node-{k + 1}" for k in range(5)]
    assert {one.get("href") for one in chosen} == {"#chosen"}
    assert picture == tree(nodes(FOUND))
    assert picture.count('class="wrong"') == 2


def test_the_page_holds_answer_stories_tree_and_what_was_looked_at() -> None:
    text = futures_page(explored(FOUND))
    for words in (
        '<b class="answer-violated">violated</b>',
        "The robot touches the table, 2.1 mm deep",
        "The scenario in which it happens",
        "The tree of decisions",
        "Environment: a &amp; b.",
        "What was looked at",
    ):
        assert words in text, words
    assert text == futures_page(explored(FOUND))


def test_words_from_outside_are_no_markup() -> None:
    hostile = "<script>alert(1)</script>\x1b[31m"
    one = replace(FOUND, found=(FOUND.found[0]._replace(headline=hostile),))
    text = futures_page(explored(one, title=hostile))
    assert "<script>alert" not in text
    assert "\x1b" not in text
    assert "scene &lt;nowhere&gt;" in text
    picture = SVG.search(text)
    assert picture is not None
    ET.fromstring(picture[0])


def test_prove_writes_a_page_with_a_replay_of_each_thing_that_goes_wrong(tmp_path: Path) -> None:
    (tmp_path / "prog.v2").write_text(
        ".PROGRAM main\n MOVE a\n IF SIG(1001) THEN\n  MOVE b\n END\n"
        " IF SIG(1002) THEN\n  x = 1/0\n END\n.END\n"
        ".LOCATIONS\na 900 0 100 90 90 0\nb 900 0 -320 90 90 0\n.END\n"
    )
    scene = ROOT / "scenes" / "cans-on-bases" / "scene.toml"
    done = vrts_text("prove", "prog.v2", "--scene", scene, "--html", "page.html", cwd=tmp_path)
    assert done.returncode == 1, done.stderr
    assert "wrote page.html" in done.stderr
    text = (tmp_path / "page.html").read_text()
    assert 'id="data"' in text
    assert 'id="data-2"' in text
    assert text.count('class="watch"') == len(re.findall(r'id="data(?:-\d+)?"', text)) >= 2
    assert re.search(r'id="data-n\d+"', text), "what goes right can be watched, too"
    assert 'id="modules"' in text
    assert str(tmp_path) not in text


RIGHT = """\
.PROGRAM main()
  MOVE a
  IF SIG(1001) THEN
    MOVE b
  END
  WAIT SIG(1002)
.END
.LOCATIONS
a 900 0 100 90 90 0
b 900 0 -100 90 90 0
.END
"""


def told_in(page: str) -> list[dict[str, Any]]:
    held = re.search(r'id="nodes">(.*?)</script>', page)
    assert held is not None
    return json.loads(held[1])["nodes"]


def test_every_leaf_that_goes_right_can_be_watched(tmp_path: Path) -> None:
    (tmp_path / "prog.v2").write_text(RIGHT)
    done = vrts_text("prove", "prog.v2", "--html", "page.html", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    page = (tmp_path / "page.html").read_text()
    nodes = told_in(page)
    ends = [node for node in nodes if not node["ends"].startswith("it goes on only")]
    assert len(ends) >= 3
    assert all(node["replay"] for node in ends)
    first, *others = (node["replay"] for node in ends)
    assert 'id="data"' in page, first
    assert all(f'id="data-{key}"' in page for key in others)
    assert "can be watched here" not in page, "all can"


def test_what_cannot_be_watched_is_told(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(whole, "MOST_CHARACTERS", 30_000)
    (tmp_path / "prog.v2").write_text(RIGHT)
    request = run_request(given_program(str(tmp_path / "prog.v2")), Where(), Language(), None)
    found = proved(request, Environment(), Asking())
    assert found.proof is not None
    drawn, tick_s = nodes(found.proof), request.setting.scene.robot.arm.tick
    runs = leaf_replays(request, found, scenarios_of(drawn, Environment(), tick_s), 24)
    given = whole.Explored("prog", "", None, found.proof, Environment(), tick_s, (), runs)
    page = futures_page(given)
    said = re.search(r"Of (\d+) lines that end well you can watch (\d+) here", page)
    assert said is not None
    assert int(said[1]) == len(runs) > int(said[2]) == page.count('id="data') > 0


def test_the_scenario_of_a_leaf_ends_as_the_leaf_does(tmp_path: Path) -> None:
    (tmp_path / "prog.v2").write_text(RIGHT)
    told = json.loads(vrts_text("prove", "prog.v2", "--format", "json", cwd=tmp_path).stdout)
    ends = [one for one in told["tree"] if one["ends"]]
    assert all(one["scenario"] for one in ends)
    completed = [one for one in ends if one["ends"] == "completed"]
    assert len(completed) >= 2
    for one in completed:
        (tmp_path / "leaf.toml").write_text(one["scenario"])
        done = vrts_text("run", "prog.v2", "--scenario", "leaf.toml", cwd=tmp_path)
        assert done.returncode == 0, done.stderr
