"""What a page shows when one looks back and returns: the page's own modules."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

from tests.__main__ import WEB

DENO = str(Path(sys.executable).parent / "deno")
BODY = """
const store = new Store();
const status = (mode) => ({ mode, program: "", line: 0, text: "", location: [], held: "", contacts: 0, step: 0, speed: null, mark: null, total: 0 });
const then = { mode: "running", program: "p", line: 3, text: "MOVE a", location: [], held: "", contacts: 0 };
const mode = () => store.now.shown?.mode ?? null;
const all = {};
shown.keepShown(store);
store.set({ status: status("moving") });
const before = store.now.shown;

looking.look(1); // its block never comes: nothing is told of that moment
store.set({ status: status("idle") });
all.meanwhile = store.now.shown === before;
looking.backToLive();
all.back = mode();

looking.look(1);
looking.tellThen(then);
all.then = mode();
looking.tellThen(null);
all.nobody_knows = mode();
looking.tellThen(then);
looking.backToLive();
looking.tellThen(null);
all.again = mode();

looking.look(1);
store.set({ alive: false, status: null }); // the session ends
looking.backToLive();
all.ended = mode();

store.set({ alive: true, status: status("idle") });
let at = null;
looking.lookAtOther(() => {
  at = [looking.lookedAt(), looking.isLive()];
  looking.tellThen(null);
});
looking.tellThen(then);
all.other = mode();
looking.look(2);
all.left = [...at, looking.lookedAt(), mode()];
at = null;
looking.look(3);
all.once = at;
looking.backToLive();
return all;
"""  # noqa: E501 -- JavaScript


def said() -> dict[str, Any]:
    """Return what the page's modules say."""
    paths = {
        "* as looking": "looking.js",
        "* as shown": "past/shown.js",
        "{ Store }": "store.js",
    }
    imports = "\n".join(
        f'import {names} from "{(WEB / "live" / path).as_uri()}";' for names, path in paths.items()
    )
    code = f"{imports}\nconst made = () => {{{BODY}}};\nconsole.log(JSON.stringify(made()));"
    words = [DENO, "eval", "--no-lock", code]
    done = subprocess.run(words, capture_output=True, text=True, check=False, timeout=60.0)
    assert done.returncode == 0, done.stderr
    answer: dict[str, Any] = json.loads(done.stdout)
    return answer


def test_who_returns_from_the_past_sees_what_is_now() -> None:
    all_ = said()
    assert all_["meanwhile"], "what is shown is of one moment"
    assert all_["back"] == "idle", "also where nothing was told of the past"
    assert (all_["then"], all_["nobody_knows"], all_["again"]) == ("running", "idle", "idle")
    assert all_["ended"] is None
    assert all_["other"] == "running"
    assert all_["left"] == [2, False, 2, "idle"], "a rehearsal is left for the past, not for now"
    assert all_["once"] is None
