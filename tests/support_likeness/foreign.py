"""What other programs call alike, on the level of tokens: JPlag and Dolos, where they are.

Neither knows VAL-II, so both are given what a module for it would give them: words of the language
in their order, with one token for any name, number or text, and nothing of comments, layout and
taught values. What was handed out is given to both as text that everybody may use.
"""

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

from tests.support_likeness.judging import Group

HERE = Path(__file__).parent / "foreign"
JARS = os.environ.get("JPLAG_JARS", "")  # a folder with jplag, language-api, text and their jars
MODULES = os.environ.get("DOLOS_MODULES", "")  # a `node_modules` with @dodona/dolos-core
LEXEME = re.compile(r';[^\n]*|"[^"\n]*"|\.?[A-Za-z_][\w.]*|\d+(?:\.\d+)?|[-+*/=<>:(),\[\]]|\n')
KEPT = frozenset(
    """
    .program .end appro appros depart departs move moves openi closei open close speed always delay
    break signal type set call for to end while do if then else goto return stop trans shift by
    inverse mmps
    """.split()  # noqa: SIM905 -- words as one reads them
)


def tokens(text: str) -> list[str]:
    """Return a program as tokens; names are `name`, numbers `number`, texts `text`."""
    found: list[str] = []
    for match in LEXEME.finditer(text):
        lexeme = match[0].lower()
        if lexeme == ".locations":
            break
        if lexeme[0] in ";\n":
            continue
        if lexeme in KEPT:
            found.append(lexeme.strip("."))
        elif lexeme[0] == '"':
            found.append("text")
        elif lexeme[0].isdigit():
            found.append("number")
        elif lexeme[0].isalpha() or lexeme[0] in "_.":
            found.append("name")
        else:
            found.append(f"sign{ord(lexeme):x}")
    return found


def missing(name: str) -> str:
    """Return why a program cannot be run here; empty: it can."""
    if name == "JPlag":
        there = JARS and any(Path(JARS).glob("jplag-*.jar")) and shutil.which("java")
        return "" if there else "JPlag is not here: JPLAG_JARS names no folder of its jars"
    core = Path(MODULES) / "@dodona" / "dolos-core"
    there = MODULES and core.is_dir() and shutil.which("node")
    return "" if there else "Dolos is not here: DOLOS_MODULES names no folder of modules"


def alike(name: str, texts: dict[str, str], given: str, where: Path) -> list[Group]:
    """Return pairs of programs, most alike first, as JPlag or Dolos rank them."""
    files = where / "tokens"
    for key, text in texts.items():
        (files / key).mkdir(parents=True)
        (files / key / "program.txt").write_text(" ".join(tokens(text)) + "\n")
    base = where / "given"
    base.mkdir()
    (base / "program.txt").write_text(" ".join(tokens(given)) + "\n")
    if name == "JPlag":
        source = str(HERE / "Compare.java")
        call = ["java", "-cp", f"{JARS}/*", source, str(files), str(base)]
    else:
        script = where / "compare.mjs"
        script.write_text((HERE / "compare.mjs").read_text().replace("MODULES", MODULES))
        call = ["node", str(script), str(files), str(base)]
    found = subprocess.run(call, capture_output=True, text=True, check=True, cwd=where)
    pairs = json.loads(found.stdout[found.stdout.index("[[") :])
    ordered = sorted(pairs, key=lambda pair: (-pair[2], pair[0], pair[1]))
    return [Group(frozenset(pair[:2]), pair[2], "") for pair in ordered]
