"""Compiling leaves nothing to the garbage collector, which is held back meanwhile."""

import gc
from collections.abc import Iterator

import pytest

from tests.support_mistakes import mistakes
from vrts.base.source import SourceFile
from vrts.lang import uncollected as module
from vrts.lang.compiler import Options, compile_source
from vrts.lang.uncollected import uncollected

RIGHT = ".PROGRAM main\nFOR i = 1 TO 3\nTYPE i*2\nEND\n.END\n"


@pytest.fixture
def collector() -> Iterator[None]:
    gc.unfreeze()  # what was loaded for all tests
    gc.collect()
    yield
    gc.unfreeze()
    gc.enable()


def left_behind(text: str, options: Options) -> int:
    """Return how many things only the collector finds after a compilation."""
    gc.disable()
    gc.collect()
    compile_source(SourceFile("main.v2", text), options)
    return gc.collect()


@pytest.mark.thorough
@pytest.mark.usefixtures("collector")
def test_no_ring_is_left() -> None:
    some = mistakes()[::40]
    texts = [RIGHT, *(m.wrong for m in some), *(m.meant for m in some)]
    for text in texts:
        compile_source(SourceFile("main.v2", text))  # what is kept for the next time
    assert {text: left_behind(text, Options()) for text in texts} == dict.fromkeys(texts, 0)


@pytest.mark.usefixtures("collector")
def test_what_was_built_is_handed_over_as_old(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MANY", 0)
    with uncollected():
        assert not gc.isenabled()
        built = [(number,) for number in range(1000)]
    assert gc.isenabled()
    assert gc.get_count()[0] < len(built)
    assert any(thing is built for thing in gc.get_objects(generation=2))
    assert gc.get_freeze_count() == 0


@pytest.mark.usefixtures("collector")
def test_what_others_froze_stays_frozen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MANY", 0)
    gc.freeze()
    frozen = gc.get_freeze_count()
    with uncollected():
        pass
    assert gc.get_freeze_count() >= frozen - 10


@pytest.mark.usefixtures("collector")
def test_a_collector_that_is_off_stays_off() -> None:
    gc.disable()
    with uncollected():
        pass
    assert not gc.isenabled()
