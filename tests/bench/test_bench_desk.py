"""The desk's server at a class of 1,000: the first screen's list, rows, and decisions.

By hand: `python -m pytest tests/bench/test_bench_desk.py -s -p no:xdist`. A real process answers;
times are those of whoever asks, from the first byte sent to the last that came.
"""

from collections.abc import Callable
from pathlib import Path
from statistics import median, quantiles
from time import perf_counter

import pytest

from tests.support_desk import write_desk_class
from tests.support_desk_server import DeskServer

ROWS = 1000
TIMES = 60
ASKED_MS = 300.0


def took_ms(ask: Callable[[], object]) -> float:
    begun = perf_counter()
    ask()
    return (perf_counter() - begun) * 1000


def p95(times: list[float]) -> float:
    return quantiles(times, n=20)[-1]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_desk_class(tmp_path_factory.mktemp("desk"), ROWS).root


def test_what_a_class_of_a_thousand_costs(folder: Path) -> None:
    cold: list[float] = []
    for _ in range(5):
        with DeskServer(folder) as desk:
            ask = lambda desk=desk: desk.get("/api/class", accept_encoding="gzip")  # noqa: E731
            cold.append(took_ms(ask))
    with DeskServer(folder) as desk, DeskServer(folder, "S. Mayr") as other:
        warm = [
            took_ms(lambda: desk.get("/api/class", accept_encoding="gzip")) for _ in range(TIMES)
        ]
        size = len(desk.get("/api/class", accept_encoding="gzip").body)
        names = [row["id"] for row in desk.whole["rows"]]
        rows = [took_ms(lambda name=name: desk.row(name)) for name in names[:: ROWS // TIMES]]
        added: list[float] = []
        revision = desk.whole["revision"]
        for number in range(TIMES):
            body = {
                "records": [
                    {"does": "comment", "student": names[number], "text": f"number {number}"}
                ],
                "expect": revision,
            }
            begun = perf_counter()
            answer = desk.request("POST", "/api/records", body)
            added.append((perf_counter() - begun) * 1000)
            assert answer.status == 200, answer.body
            revision = answer.json["revision"]
        give = {"does": "give", "item": "grip", "students": names[:500]}
        bulk = took_ms(lambda: desk.add(give))
        others = took_ms(lambda: other.get("/api/class", accept_encoding="gzip"))
        numbers = took_ms(lambda: desk.get("/api/statistics"))
    print(
        f"\n/api/class of {ROWS} rows, cold: median {median(cold):.0f} ms, slowest {max(cold):.0f}"
        f" (asked {ASKED_MS:.0f}); again: median {median(warm):.0f}, {size / 1000:.0f} kB"
        f"\n  /api/row: median {median(rows):.0f} ms, p95 {p95(rows):.0f}, slowest {max(rows):.0f}"
        f"\n  a decision: median {median(added):.0f} ms, p95 {p95(added):.0f};"
        f" an item for 500: {bulk:.0f}; the other desk's list after that: {others:.0f}"
        f"\n  /api/statistics: {numbers:.0f} ms",
        end="",
    )
    assert min(cold) < 10 * ASKED_MS
