"""Files made to be slow or large: any input is answered within 10 s and 500 MB."""

import subprocess
import sys
from collections.abc import Callable

import pytest

MOST_SECONDS, MOST_MB = 10.0, 500.0
MOST_BYTES = 4_000_000
MANY = 60_000

SHAPES: dict[str, Callable[[], str]] = {
    "nested parentheses": lambda: ("x = " + "(" * 190 + "1" + ")" * 190 + "\n") * 9000,
    "nested brackets": lambda: ("x = " + "a[" * 150 + "1" + "]" * 150 + "\n") * 8000,
    "long sums": lambda: ("x = " + "1+" * 120 + "1\n") * 15_000,
    "operators before operands": lambda: ("x = " + "NOT " * 45 + "1\n") * 15_000,
    "conditions": lambda: ("x = " + "a==b AND " * 24 + "1\n") * 15_000,
    "names": lambda: "".join(f"v{k} = w{k}\n" for k in range(MANY)),
    "names alike": lambda: "".join(f"name{k:05d} = nama{k:05d}\n" for k in range(MANY)),
    "unknown words": lambda: "".join(f"abc{k}x y\n" for k in range(MANY)),
    "labels": lambda: "".join(f"{k} READY\n" for k in range(MANY)),
    "jumps": lambda: "GOTO 60000\n" * MANY + "60000 READY\n",
    "jumps into loops": lambda: (
        "FOR i = 1 TO 3\n" * 20_000 + "5 READY\n" + "END\n" * 20_000 + "GOTO 5\n" * 20_000
    ),
    "exits": lambda: "DO\n" * 20_000 + "EXIT 3\n" * 20_000 + "UNTIL x\n" * 20_000,
    "open structures": lambda: "IF x THEN\n" * MANY,
    "loops": lambda: "".join(f"WHILE x{k} DO\n" for k in range(30_000)) + "END\n" * 30_000,
    "hands": lambda: "OPEN\n" * MANY,
    "values": lambda: "CASE x OF\n" + "VALUE 1:\n" * MANY + "END\n",
    "bad lines": lambda: "MOVEE x y z ( \n" * MANY,
    "pasted quotes": lambda: "TYPE “a”\n" * MANY,
    "calls": lambda: "".join(f"CALL nothere{k}\n" for k in range(MANY)),
    "programs": lambda: "".join(
        f".PROGRAM p{k}(a)\nCALL p{(k * 7 + 1) % 20_000}(a)\n.END\n" for k in range(20_000)
    ),
    "chains of loops": lambda: "".join(
        f".PROGRAM p{k}\nWHILE x DO\nCALL p{k + 1}\nEND\n.END\n" for k in range(20_000)
    ),
    "second programs": lambda: "".join(
        f".PROGRAM p{k}\nPCEXECUTE p{k + 1}\nCALL p{k + 2}\nREADY\n.END\n" for k in range(20_000)
    ),
    "sections": lambda: ".PROGRAM a\n.END\n" * 150_000,
    "locations": lambda: (
        ".LOCATIONS\n" + "".join(f"p{k} 1 2 3 4 5 6\n" for k in range(130_000)) + ".END\n"
    ),
    "reals": lambda: ".REALS\n" + "".join(f"a{k} 1\n" for k in range(330_000)) + ".END\n",
    "stray signs": lambda: ("%" * 254 + "\n") * 15_000,
    "stray steps": lambda: "x\n.END\n" * 550_000,
    "ends": lambda: ".END\n" * 790_000,
    "unknown sections": lambda: ".X\n" * 1_300_000 + ".END\n",
    "undefined labels": lambda: (
        "".join(f"{k} READY\n" for k in range(1, 30_000)) + "GOTO 31000\n" * 30_000
    ),
    "local names": lambda: "".join(f".v{k} = 1\n" for k in range(MANY)),
    "formals": lambda: f".PROGRAM p({','.join(f'a{k:04d}' for k in range(1500))})\n.END\n" * 430,
    "passed on": lambda: (
        "".join(f".PROGRAM p{k}(a)\nCALL p{k + 1}(a)\n.END\n" for k in range(20_000))
        + ".PROGRAM p20000(a)\ny = a+1\n.END\n.PROGRAM q\nCALL p0(x)\ny = x\n.END\n"
    ),
    "loops that call": lambda: (
        "".join(f".PROGRAM p{k}\ny = 1\nCALL p{k + 1}\n.END\n" for k in range(49))
        + ".PROGRAM p49\n"
        + "y = 1\n" * 900
        + ".END\n"
        + ".PROGRAM q\nx = 1\n"
        + "WHILE x DO\nCALL p0\nEND\n" * 20_000
        + ".END\n"
    ),
    "assignments": lambda: (
        "".join(
            (f".PROGRAM z{k}\n" if k % 50_000 == 0 else "") + f"v{k} = w{k % 50_000}\n"
            for k in range(200_000)
        )
        + ".END\n"
    ),
    "one letter": lambda: ("a" * 9000 + "\n") * 440,
    "NULs": lambda: "\0" * (MOST_BYTES - 1),
    "lone CRs": lambda: "MOVE p\r" * 500_000,
}
SCRIPT = r"""
import re, sys, time
from pathlib import Path
from vrts.base.diagnostic import Diagnostic
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS
from vrts.lang.reading.decoding import decode
from vrts.report.screen.text import diagnostic_text
data = sys.stdin.buffer.read()
began = time.process_time()
source = decode(data, "hostile.v2")
if not isinstance(source, Diagnostic):
    for d in compile_source(source, Options(DIALECTS[sys.argv[1]])).diagnostics:
        diagnostic_text(d, color=False)
peak = re.search(r"VmHWM:\s*(\d+)", Path("/proc/self/status").read_text())[1]
print(time.process_time() - began, int(peak) / 1024)
"""


@pytest.mark.parametrize("dialect", ["val2", "val2+"])
@pytest.mark.parametrize("shape", SHAPES)
def test_answered_in_time(shape: str, dialect: str) -> None:
    body = SHAPES[shape]()
    text = body if ".END" in body else f".PROGRAM main\n{body}.END\n"
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, dialect],
        input=text.encode()[:MOST_BYTES],
        capture_output=True,
        check=True,
        timeout=60,
    )
    seconds, megabytes = map(float, done.stdout.split())
    print(f"\n{shape} ({dialect}): {seconds:.2f} s, {megabytes:.0f} MB")
    assert seconds <= MOST_SECONDS
    assert megabytes <= MOST_MB
