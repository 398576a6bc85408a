"""The log of a robot beside the run of a program, as a step asks for it."""

from collections.abc import Callable
from pathlib import Path

import numpy as np

from vrts.base.units import mm
from vrts.learn.at_program import not_there, said
from vrts.learn.lesson import DONE, Answer, LogWish
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.files import read_bytes, shown
from vrts.pipeline.request import NO_CHECKS, Request
from vrts.pipeline.scenes import free_setting
from vrts.pipeline.where import Where
from vrts.run_files.simulated import simulate
from vrts.validate.comparison import read_and_compare
from vrts.validate.errors import lengths
from vrts.validate.log.log import GivenLog
from vrts.validate.offsets import Wanted


def look_at_log(wish: LogWish, inside: Callable[[str], Path]) -> Answer:
    """Return whether a log is of the run of a program, and as near to it as a step asks for.

    Args:
        wish: What is asked for.
        inside: Returns the place of a file in the lesson's folder.

    Raises:
        CannotRead: A file cannot be read.
        Refused: The log, the scene or the lab has errors.
    """
    program, log = inside(wish.program), inside(wish.log)
    lab = None if wish.lab is None else inside(wish.lab)
    for name, place in ((wish.program, program), (wish.log, log), (wish.lab, lab)):
        if name is not None and place is not None and not place.is_file():
            return not_there(name)
    given = ProgramFile(read_bytes(program), shown(program))
    setting = free_setting(Where(scene=wish.scene, lab=lab), program.parent)
    found = simulate(Request(given, setting, checks=NO_CHECKS))
    if found.run is None:
        errors = [d for d in found.diagnostics if d.is_error]
        return said(errors[0]) if errors else not_there(wish.program)
    compared = read_and_compare(found.run, GivenLog(shown(log), (read_bytes(log),)), Wanted())
    worst = float(np.max(lengths(compared.after)))
    if wish.within_m is not None and worst > wish.within_m:
        wanted = f"{mm(wish.within_m):.0f} mm"
        why = f"`{wish.log}` is {mm(worst):.1f} mm off the run at the worst; {wanted} is wanted"
        return Answer(done=False, why=why)
    if wish.beyond_m is not None and worst < wish.beyond_m:
        why = f"`{wish.log}` is never more than {mm(worst):.1f} mm off the run: no error to look at"
        return Answer(done=False, why=why)
    return DONE
