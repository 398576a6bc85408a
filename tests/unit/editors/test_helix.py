"""What Helix is told: a server of the language, an adapter, and files of these kinds."""

import tomllib

from tests.support_commands import vrts


def test_the_set_up_for_helix_starts_what_vrts_offers() -> None:
    found = tomllib.loads(vrts("editor", "helix").stdout.decode())
    (language,) = found["language"]
    assert language["file-types"] == ["v2", "pg", "lc"]
    (server,) = language["language-servers"]
    commands = [found["language-server"][server], language["debugger"]]
    assert [(c["command"], c["args"]) for c in commands] == [("vrts", ["lsp"]), ("vrts", ["dap"])]
    (template,) = language["debugger"]["templates"]
    assert (template["request"], template["args"]) == ("launch", {"program": "{0}"})
