"""URScript read back: how near its motions are to the runs, over programs drawn by chance."""

import os
import time

from tests.oracle.urscript.drawn import drawn
from tests.oracle.urscript.interpreter import Motion
from tests.support_urscript import Off, carried_out, differences, exported, told_alike
from vrts.base.source import SourceFile
from vrts.dispatch.saying.table import read_table
from vrts.engine.memory.events import Printed

DRAWN = int(os.environ.get("VRTS_DRAWN", "80"))


def test_how_near_urscript_is_on_programs_drawn_by_chance() -> None:
    """Every program in four ways: inputs 1001 and 1002 off and on."""
    begun = time.perf_counter()
    worst: dict[str, Off] = {}
    counted: dict[str, int] = {}
    outputs = typed = runs = characters = refused = 0
    texts: set[str] = set()
    for number in range(DRAWN):
        for ways in range(4):
            inputs = {1001: bool(ways & 1), 1002: bool(ways & 2), 1003: True}
            folder, run = exported(drawn(number), inputs=inputs)
            if folder.files is None:
                refused += 1
                print(number, ways, [d.headline for d in folder.diagnostics if d.is_error])
                continue
            table = read_table(SourceFile("io.toml", folder.files["io.toml"].decode()))
            on = {pin for signal, pin in table.inputs.items() if inputs[signal]}
            text = folder.files["program.script"].decode()
            done = carried_out(text, run, lambda pin, on=on: pin in on)
            told_alike(done, run, table.outputs)
            moved = [item for item in done if isinstance(item, Motion)]
            for motion, off in zip(moved, differences(done, run), strict=True):
                counted[motion.word] = counted.get(motion.word, 0) + 1
                worst[motion.word] = Off(*map(max, off, worst.get(motion.word, off)))
            outputs += sum(item[0] == "out" for item in done if not isinstance(item, Motion))
            printed = [e.text for e in run.events if isinstance(e, Printed)]
            told = [item for item in done if not isinstance(item, Motion) and item[0] == "text"]
            assert len(told) == sum(len(row.split()) for row in printed)
            typed, runs, characters = typed + len(told), runs + 1, characters + len(text)
            texts.add(text)
    print(
        f"\n{DRAWN} programs, {runs} runs, {refused} refused, {len(texts)} texts"
        f" ({characters / runs:.0f} characters each), {time.perf_counter() - begun:.0f} s"
    )
    print(f"{outputs} outputs in the order and at the time of the run, {typed} messages")
    for word, off in worst.items():
        print(
            f"{word}: {counted[word]} motions, at most {off.mm:.1e} mm, {off.rad:.1e} rad off,"
            f" joints {off.joints_rad:.1e} rad"
        )
    assert runs > 3 * DRAWN
