"""The same thing has one name in every command; a command that calls it otherwise is found here."""

import click
import pytest

from tests.unit.cli.grammar.every import every_command, options_of
from vrts.cli.grammar.command import Command

EVERY = every_command()
OUTPUTS = {"--out", "--outfile", "--output-file", "--to-file", "--target", "--dest"}
ONE_NAME = {  # what nobody may call a thing by, and what it is called
    **dict.fromkeys(OUTPUTS, "--output"),
    **dict.fromkeys(("--program", "--main", "--start-with"), "--entry"),
    **dict.fromkeys(("--force", "--replace-files", "--clobber"), "--overwrite"),
    **dict.fromkeys(("--as-json", "--js"), "--json"),
    **dict.fromkeys(("--silent", "--no-output"), "--quiet"),
    **dict.fromkeys(("--colour", "--no-color", "--no-colour"), "--color"),
}
DESCRIBES = {  # options that hold what another holds elsewhere, by the words of their help
    "--entry": ("program to execute", "program of the file to execute", "the program to look for"),
    "--overwrite": ("replace the file if", "replace files that", "replace a file that"),
}
SHORT = {"-o": "--output", "-q": "--quiet", "-y": "--yes", "-h": "--help", "-V": "--version"}


@pytest.mark.parametrize("words", EVERY)
def test_nothing_has_another_name(words: str) -> None:
    options = options_of(EVERY[words])
    for wrong, right in ONE_NAME.items():
        assert wrong not in options, f"`vrts {words} {wrong}` is called `{right}` elsewhere"
    for short, long in SHORT.items():
        if short in options or long in options:
            assert options.get(short, options.get(long)) is options.get(long), f"{short}, {long}"
    if "--output" in options:
        assert "-o" in options, "`--output` is `-o`, too"
    for name, option in options.items():
        for long, starts in DESCRIBES.items():
            if name.startswith("--") and (option.help or "").lower().startswith(starts):
                assert name == long, f"`{name}` is called `{long}` elsewhere"


@pytest.mark.parametrize("words", EVERY)
def test_every_command_takes_quiet_and_color(words: str) -> None:
    command = EVERY[words]
    assert isinstance(command, Command)
    options = options_of(command)
    assert options["--quiet"] is options["-q"]
    assert isinstance(options["--color"].type, click.Choice)
    assert list(options["--color"].type.choices) == ["auto", "always", "never"]


@pytest.mark.parametrize("words", EVERY)
def test_json_is_a_form_and_a_word_of_its_own(words: str) -> None:
    options = options_of(EVERY[words])
    form = options.get("--format")
    forms = list(form.type.choices) if form and isinstance(form.type, click.Choice) else []
    assert ("json" in forms) == ("--json" in options)
    if forms:
        assert forms[0] == "full", "what people read is called `full`"
    if form is not None and "--json" in options:
        assert form.name == options["--json"].name
