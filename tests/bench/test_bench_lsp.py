"""The language server: how long answers take while a file of 2,000 lines is typed."""

import gc
import json
import statistics
import time
from collections.abc import Callable, Iterator
from itertools import pairwise
from pathlib import Path

import psutil
import pytest

from tests.bench.test_bench_compile import STEPS, realistic
from tests.support_lsp import Client
from vrts.lsp.answers.checking import check
from vrts.lsp.answers.colouring import coloured
from vrts.lsp.answers.completing import complete
from vrts.lsp.answers.finding import references
from vrts.lsp.answers.fixing import remedies
from vrts.lsp.answers.folding import folds
from vrts.lsp.answers.hovering import hover
from vrts.lsp.answers.lenses import lenses
from vrts.lsp.answers.near import near
from vrts.lsp.answers.signatures import signature
from vrts.lsp.answers.symbols import symbols
from vrts.lsp.documents.documents import Document
from vrts.lsp.documents.linking import group
from vrts.lsp.server.colours import changed, encoded
from vrts.lsp.server.outlining import converted as as_symbol
from vrts.lsp.server.places import Places
from vrts.lsp.server.serving import RARELY

LINES = 2_000
LIMIT_S = 0.050
KEYS = 15
LINKED, LINK_LIMIT_S = 200, 0.010
LARGE = 10_000  # lines of one program
WHOLE_MS = {LINES: 113.0, LARGE: 678.0}  # of a whole check on the machine that the limits are for
FOLDER, LONG, FIRST_LIMIT_S = 300, 1_000, 1.5  # files, lines of each


def typed(text: str, key: int) -> tuple[Document, int]:
    """Return the text with one more letter in its middle, and the offset after it."""
    at = text.index("\n", len(text) // 2) + 1
    line = "        MOVES part" + "xyz"[key % 3] * (key // 3) + "\n"
    return Document("/bench/a.v2", text[:at] + line + text[at:]), at + len(line) - 1


@pytest.fixture(autouse=True)
def as_in_the_server() -> Iterator[None]:
    before = gc.get_threshold()
    gc.set_threshold(*RARELY)
    yield
    gc.set_threshold(*before)


def test_answers_while_typing() -> None:
    text = realistic(LINES)
    answers: dict[str, Callable[[Document, int, list[Document]], object]] = {
        "names": lambda d, _, __: d.names.by_target,
        "hover": hover,
        "completion": complete,
        "signature": signature,
        "references": references,
        "symbols": lambda d, _, __: symbols(d),
        "folding": lambda d, _, __: folds(d),
        "colours": lambda d, _, __: list(coloured(d)),
    }
    typed(text, 0)[0].names  # noqa: B018 -- the file was open before
    list(coloured(typed(text, 0)[0]))
    print(f"\n{text.count(chr(10)):,} lines, processor time of an answer after a key:")
    slowest = 0.0
    for name, answer in answers.items():
        times: list[float] = []
        for key in range(KEYS):
            document, offset = typed(text, key)
            began = time.process_time()
            answer(document, offset, group(document, []))
            times.append(time.process_time() - began)
        median = statistics.median(times)
        slowest = max(slowest, median)
        print(f"  {name:<12} {1000 * median:5.1f} ms, at most {1000 * max(times):5.1f} ms")
    assert slowest <= LIMIT_S


def test_a_large_program() -> None:
    steps = STEPS * (LARGE // STEPS.count("\n"))
    text = f".PROGRAM main\n        n = 0\n{steps}.END\n"
    typed(text, 0)[0].read()
    times: list[float] = []
    for key in range(1, KEYS):
        document, _ = typed(text, key)
        began = time.process_time()
        document.read()
        times.append(time.process_time() - began)
    median = 1000 * statistics.median(times)
    print(f"\nnames of one program of {LARGE:,} lines after a key: {median:.0f} ms")


@pytest.mark.parametrize(("lines", "limit_s"), [(LINES, 0.050), (LARGE, 0.150)])
@pytest.mark.parametrize("kind", ["many programs", "one program"])
def test_code_actions_after_a_key(kind: str, lines: int, limit_s: float) -> None:
    """What mends a line of a long text, told from what was found before; and by a whole check."""
    steps = STEPS * (lines // STEPS.count("\n"))
    one = f".PROGRAM main\n        n = 0\n{steps}.END\n"
    text = one if kind == "one program" else realistic(lines)
    before, _ = typed(text, 0)
    found = check(before)
    times: dict[str, list[float]] = {"near": [], "whole": []}
    for key in range(1, KEYS if lines == LINES else 6):
        for name, taken in times.items():
            document, offset = typed(text, key)
            at = document.source.line_of(offset)
            began = time.process_time()
            told = (
                check(document)
                if name == "whole"
                else near(document, range(at - 1, at), before, found, lambda d=document: [d])
            )
            assert told is not None
            here = [d for d in told if d.primary and d.primary.span.line == at]
            _ = [remedy for d in here for remedy in remedies(document, d)]
            taken.append(time.process_time() - began)
    took, whole = (1000 * statistics.median(taken) for taken in times.values())
    print(
        f"\ncode actions, {text.count(chr(10)):,} lines, {kind}: {took:.0f} ms after a key"
        f" (with its names), {whole:.0f} ms by a whole check"
    )
    assert took <= 1000 * limit_s * max(1.0, whole / WHOLE_MS[lines])


def test_the_outline_of_many_small_programs() -> None:
    took: dict[int, float] = {}
    for count in (1_000, 2_000, 4_000, 8_000):
        text = "".join(f".PROGRAM p{n}\n10      CALL p{n + 1}\n.END\n" for n in range(count))
        document = Document("/bench/many.v2", text)
        document.read()
        places = Places(document.source, "utf-16")
        times: list[float] = []
        for _ in range(5):
            fresh = Document("/bench/many.v2", text)
            fresh.read()
            began = time.process_time()
            assert len([as_symbol(symbol, places) for symbol in symbols(fresh)]) == count
            assert len(lenses(fresh)) >= 2 * count
            times.append(time.process_time() - began)
        took[count] = statistics.median(times)
    told = ", ".join(f"{n:,}: {1000 * s:.0f} ms" for n, s in took.items())
    print(f"\nsymbols and lenses of small programs: {told}")
    assert took[8_000] <= 2 * 8 * took[1_000]


def test_linking() -> None:
    body = "        CALL p{}\n        MOVE s{}\n.END\n"
    texts = [f".PROGRAM p{n}\n" + body.format(n + 1, n) for n in range(LINKED)]
    documents = [Document(f"/bench/{n}.v2", text) for n, text in enumerate(texts)]
    for document in documents:
        document.names.summarise()
    times: list[float] = []
    for key in range(KEYS):
        edited, _ = typed(texts[0], key)  # only what changes is summed up again
        began = time.process_time()
        found = group(edited, documents[1:])
        times.append(time.process_time() - began)
        assert len(found) == LINKED
    seconds = statistics.median(times)
    print(f"\nlinking {LINKED} programs that call one another: {1000 * seconds:.1f} ms")
    assert seconds <= LINK_LIMIT_S


def test_semantic_tokens_after_a_key() -> None:
    text = realistic(LINES)
    documents = [typed(text, key)[0] for key in range(KEYS)]
    numbers = [encoded(d, Places(d.source, "utf-16")) for d in documents]
    whole = len(json.dumps(numbers[0]))
    times: list[float] = []
    sizes: list[int] = []
    for before, after in pairwise(numbers):
        began = time.process_time()
        edits = changed(before, after)
        times.append(time.process_time() - began)
        sizes.append(sum(len(json.dumps(edit.data)) for edit in edits))
    took = 1000 * statistics.median(times)
    print(
        f"\nsemantic tokens: {whole:,} bytes; a change: {max(sizes)} bytes, found in {took:.1f} ms"
    )
    assert max(sizes) < 100


def test_the_first_answers_in_a_folder_of_long_files(tmp_path: Path) -> None:
    for number in range(FOLDER):
        name = f"part{number}"
        steps = STEPS.replace("part", name) * (LONG // STEPS.count("\n"))
        text = f".PROGRAM p{number}\n        n = 0\n{steps}.END\n"
        (tmp_path / f"f{number:03}.v2").write_text(text, "utf-8")
    mine = ".PROGRAM main\n        CALL p1\n        MOVE part\n.END\n"
    with Client(tmp_path) as client:
        server = psutil.Process(client.process.pid)

        def spent() -> float:
            times = server.cpu_times()
            return times.user + times.system

        idle = spent()
        client.open("a.v2", mine)
        client.about("hover", "a.v2", (1, 14))
        client.about("completion", "a.v2", (2, 17))
        client.diagnostics("a.v2", lambda _: True)
        first = spent() - idle
        client.about("definition", "a.v2", (1, 14))
        print(
            f"\n{FOLDER} files of {LONG:,} lines: hover, completion and diagnostics after"
            f" {first:.2f} s of processor time, all files read after {spent() - idle:.1f} s"
        )
    assert first < FIRST_LIMIT_S


def test_round_trips(tmp_path: Path) -> None:
    text = realistic(LINES)
    line = text.count("\n") // 2
    times: dict[str, list[float]] = {"completion": [], "hover": []}
    with Client(tmp_path) as client:
        client.open("a.v2", text)
        client.diagnostics("a.v2")
        client.change("a.v2", "        MOVES \n", (line, 0), (line, 0))
        for key in range(KEYS):
            client.change("a.v2", "x", (line, 14 + key), (line, 14 + key))
            for method, found in times.items():
                began = time.perf_counter()
                client.about(method, "a.v2", (line, 15 + key))
                found.append(time.perf_counter() - began)
            time.sleep(0.25)  # a check begins meanwhile
    print()
    for method, found in times.items():
        print(f"{method} by a client, wall clock: median {1000 * statistics.median(found):.0f} ms")
