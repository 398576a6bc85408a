"""Fuzzes the compiler with atheris: `python -m tests.fuzz --minutes 15`.

Needs the extra `fuzz` (`pip install -c .ci/constraints.txt -e '.[fuzz]'`). The first byte chooses
the dialect, the rest is a file. Seeds are the programs of the tests, examples and pages; words come
from the vocabulary. Short files are tried faster, so the default length is short; `--length 4000`
tries long ones. The minutes are of the processor, so a busy machine takes nothing from them; the
last line tells how many files they were enough for. What raises, takes too long or too much memory
is written into the folder given by `--out`; make it small, put it into `tests/data/lang_findings`,
where a test compiles it from then on, and mend the fault.
"""

import argparse
import importlib
import os
import re
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

atheris: Any = importlib.import_module("atheris")  # an extra that has no types

with atheris.instrument_imports(include=["vrts.lang", "vrts.ir"]):
    from vrts.base.diagnostic import Diagnostic
    from vrts.base.source import SourceFile
    from vrts.cli.language.problems import FORMS, render
    from vrts.ir.dump import dump
    from vrts.ir.verify import verify
    from vrts.lang.compiler import Options, compile_source
    from vrts.lang.dialect import DIALECTS, VAL2
    from vrts.lang.reading.decoding import decode
    from vrts.lang.vocabulary.functions import FUNCTIONS
    from vrts.lang.vocabulary.instructions import INSTRUCTIONS
    from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS
    from vrts.lang.writing.layout import layout
    from vrts.report.formats.checked import Checked

ROOT = Path(__file__).parents[2]
FENCED = re.compile(r"^```[^\n]*\n(.*?)^```", re.MULTILINE | re.DOTALL)
SEEDS = ("tests/golden/lang", "tests/data/lang_findings", "examples", "tests/spec", "vrts/pages")
CHOICES = [None, *DIALECTS.values()]
SLOW_S = 10.0  # of the processor, for one file


def one_input(data: bytes) -> None:
    """Compile and lay out one file; whatever is wrong with it is a diagnostic."""
    dialect = CHOICES[data[0] % len(CHOICES)] if data else None
    source = decode(data[1:], "fuzz.v2")
    if isinstance(source, Diagnostic):
        return
    found = compile_source(source, Options(dialect))
    if found.module is None:
        assert any(d.is_error for d in found.diagnostics)
    else:
        assert verify(found.module) == []
        dump(found.module)
    for d in found.diagnostics:
        for label in (d.primary, *d.secondary):
            if label is not None:
                size = len(label.span.source.text)
                assert 0 <= label.span.start <= label.span.end <= size
    for form in FORMS:
        render([Checked("fuzz.v2", found.diagnostics, found.module is not None)], form)
    once = layout(source, dialect or VAL2)
    assert layout(SourceFile("fuzz.v2", once), dialect or VAL2) == once


def limited(minutes: float) -> Callable[[bytes], None]:
    """Return a function that tries files, and ends the process after minutes of the processor."""
    tried = 0

    def one(data: bytes) -> None:
        nonlocal tried
        began = time.process_time()
        one_input(data)
        ended = time.process_time()
        assert ended - began <= SLOW_S, "one file takes too long"
        tried += 1
        if ended > 60 * minutes:
            print(
                f"{tried:,} files in {ended / 60:.1f} minutes of the processor, without a finding"
            )
            sys.stdout.flush()
            os._exit(0)  # atheris has no other way to end well

    return one


def seeds() -> Iterator[bytes]:
    """Return the programs that stand in files and on pages."""
    for folder in SEEDS:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in (".v2", ".as", ".val"):
                yield path.read_bytes()
            elif path.suffix == ".md":
                for block in FENCED.finditer(path.read_text("utf-8")):
                    yield block[1].encode()


def main() -> None:
    """Prepare seeds and words, and fuzz."""
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--minutes", type=float, default=15)
    parser.add_argument("--length", type=int, default=700, help="longest file, in bytes")
    parser.add_argument("--out", type=Path, default=Path("fuzz-out"))
    options = parser.parse_args()
    corpus = options.out / "corpus"
    corpus.mkdir(parents=True, exist_ok=True)
    number = 0
    for seed in seeds():
        for choice in range(len(CHOICES)):
            number += 1
            (corpus / f"seed{number}").write_bytes(bytes([choice]) + seed)
    words = options.out / "words.txt"
    texts = [*INSTRUCTIONS, *QUALIFIERS, *OPERATORS, *(name.upper() for name in FUNCTIONS)]
    words.write_text("\n".join(f'"{text}"' for text in texts) + '\n"\\x0a.PROGRAM "\n"\\x0a.END"\n')
    atheris.Setup(
        [
            sys.argv[0],
            str(corpus),
            f"-dict={words}",
            f"-artifact_prefix={options.out}/",
            f"-max_len={options.length}",
            "-timeout=120",
            "-print_final_stats=1",
        ],
        limited(options.minutes),
    )
    atheris.Fuzz()


if __name__ == "__main__":
    main()
