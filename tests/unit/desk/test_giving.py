"""Whom the page leaves out when it gives something to all: asked of its own module, in Node."""

import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from vrts.web.assets import asset

ASKS = """
import { apart, changing } from "./giving.mjs";
const row = (id, more) => ({ id, name: id, excused: false, ...more });
const rows = [row("ann"), row("ben", { set_by: ["huber"] }), row("cem", { set_by: ["mayr"] }),
  row("dan", { excused: true })];
const ids = (some) => some.map((one) => one.id);
const found = apart(rows, "huber"), all = changing(rows);
console.log(JSON.stringify([ids(found.getting), found.why, ids(all.open), ids(all.fixed)]));
"""


@pytest.mark.skipif(shutil.which("node") is None, reason="needs Node")
def test_marks_of_others_and_the_excused_are_left_out_and_told(tmp_path: Path) -> None:
    for path in ("desk/work/giving.js", "desk/words.js", "live/names.js", "live/dom.js"):
        text = re.sub(r'from "[./a-z]*?(\w+)\.js"', r'from "./\1.mjs"', asset(path))
        (tmp_path / f"{Path(path).stem}.mjs").write_text(text, encoding="utf-8")
    (tmp_path / "asks.mjs").write_text(ASKS, encoding="utf-8")
    said = subprocess.run(
        ["node", str(tmp_path / "asks.mjs")], capture_output=True, text=True, check=True
    )
    assert json.loads(said.stdout) == [
        ["ann", "ben"],
        [
            "Left out, as another grader has set their mark: cem.",
            "Left out, as they are excused: dan.",
        ],
        ["ann"],
        ["ben", "cem", "dan"],
    ]
