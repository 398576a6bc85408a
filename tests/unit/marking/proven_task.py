"""A task that asks for every future in a hidden environment, full of words found nowhere else."""

from pathlib import Path

TASK = """\
[task]
title = "Parts by name"
scene = "cans-on-bases"

[[via]]
name = "the far side"
at_mm = [900, 300, 100]

[prove]
environment = "staff/secret-cell.toml"
hidden = true

[time]
reference_s = 5
"""
USUAL = '[prompts]\nanswers = ["a"]\n'
TITLE, PROPERTY, ANSWER, SIGNAL = "cell 471108150815", "never 815047110815", "b471147114711", "1031"
ENVIRONMENT = f"""\
title = "{TITLE}"

[prompts]
answers = ["a", "{ANSWER}"]

[[inputs]]
signal = {SIGNAL}
is = "free"

[[never]]
title = "{PROPERTY}"
signals = [7, {SIGNAL}]
"""
MARKERS = (TITLE, PROPERTY, ANSWER, SIGNAL)

HEAD = '.PROGRAM main()\n        PROMPT "which part? ", $part\n'
TAIL = """\
        MOVE there
        DRIVE 6, 10, 100
.END
.LOCATIONS
there 900 300 100 90 90 0
.END
"""
GOOD = HEAD + TAIL  # whatever is answered
FITTED = HEAD + '        IF $part <> "a" THEN\n          SIGNAL 7\n        END\n' + TAIL


def written(folder: Path, task: str = TASK, environment: str = ENVIRONMENT) -> Path:
    """Write the task with its reference into a folder; return it."""
    (folder / "staff").mkdir(parents=True)
    (folder / "task.toml").write_text(task)
    (folder / "scenario.toml").write_text(USUAL)
    (folder / "staff" / "secret-cell.toml").write_text(environment)
    (folder / "staff" / "solution.v2").write_text(GOOD)
    return folder
