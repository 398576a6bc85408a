"""How long the panel beside the text waits for an answer while a location is dragged.

`python -m pytest tests/bench/test_bench_dragging.py -s -p no:xdist`
"""

import asyncio
from pathlib import Path
from time import perf_counter

import numpy as np

from tests.bench.usual import slowness
from tests.unit.lsp.heard import begun
from tests.unit.lsp.in_a_cell import setting
from tests.unit.lsp.server.test_dragging import TEXT

DRAGS = 200  # places on the way


def test_reach_while_a_location_is_dragged(tmp_path: Path) -> None:
    program = setting(tmp_path)
    uri = program.as_uri()

    async def drag() -> list[float]:
        heard = await begun(TEXT, uri=uri, runs=True)
        taken: list[float] = []
        for k in range(DRAGS + 1):
            at = [900.0 - k, 2.0 * k - 200.0, 100.0]
            asked = {"uri": uri, "file": str(program), "name": "a", "subscripts": [], "at": at}
            before = perf_counter()
            found = await heard.ask("vrts/reach", asked)
            taken.append(perf_counter() - before)
            assert found["result"]["reached"] is not None, found
        heard.session.leave()
        return taken

    slow = slowness()
    first, *others = asyncio.run(drag())
    p50, p95 = np.percentile(others, (50, 95)) * 1e3
    print(
        f"\nreach while a location is dragged, {DRAGS} places: p50 {p50:.1f} ms, p95 {p95:.1f} ms"
    )
    print(f"the first answer, which begins the process: {first:.2f} s")
    print(f"(this machine: {slow:.2f} and {slowness():.2f} times slower than usual)")
