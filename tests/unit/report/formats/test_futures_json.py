"""A proof over every future, for programs."""

import json

import msgspec

from tests.unit.report.proofs import OPEN, VIOLATED
from vrts.report.formats.futures_json import futures_json
from vrts.report.formats.futures_schema import Futures
from vrts.report.formats.json_text import json_text


def test_everything_that_was_decided_is_there() -> None:
    found = json.loads(json_text(futures_json("lower.v2", VIOLATED, ('title = "x"\n',))))
    assert found["schema"] == "vrts.futures/1"
    assert found["answer"] == "violated"
    first, second = found["found"]
    assert (first["line"], first["step"], first["wrong"]) == (3, 2, "contact")
    assert first["scenario"] == 'title = "x"\n'
    assert second["scenario"] is None
    assert first["decisions"][0] == {
        "time_s": 0.28,
        "what": "input",
        "number": 1001,
        "value": True,
        "words": "input 1001 is on",
        "program": "lower",
        "step": 1,
        "line": 2,
    }
    assert first["decisions"][2]["line"] is None
    branch = {"parent": None, "decided": None, "ends": "", "ended_s": None, "into": None}
    assert found["tree"] == [{**branch, "scenario": None}]
    with_leaf = futures_json("lower.v2", VIOLATED, (), {0: "title = 'it'"})
    assert with_leaf["tree"] == [{**branch, "scenario": "title = 'it'"}]


def test_what_is_open_is_there() -> None:
    found = futures_json("lower.v2", OPEN)
    assert found["open"] == ["17 futures: the budget of states is spent"]
    assert found["covered"]["states"] == 1234  # type: ignore[index]


def test_its_schema_names_all_that_it_holds_and_nothing_else() -> None:
    for proof in (VIOLATED, OPEN):
        text = json_text(futures_json("lower.v2", proof))
        read = msgspec.json.decode(text, type=Futures)
        assert read == json.loads(text)  # what the schema does not name is left out of the first
        msgspec.json.decode(json_text(dict(read)), type=Futures)
