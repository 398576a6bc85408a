"""The bytes of a log as a table, whatever wrote them: text, a bag of ROS 2, MATLAB."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, error
from vrts.validate.log.log_table import LOG_UNREADABLE, LogTable, read_table
from vrts.validate.log.unreadable import Unreadable

BAGS = (b"\x89MCAP0\r\n", b"SQLite format 3\0")  # how files of bags begin
MATLAB = b"MATLAB "


class _Form(NamedTuple):
    """What is not text."""

    title: str
    package: str  # of ours that has what reads it


BAG, MAT = _Form("a bag of ROS 2", "vrts[ros]"), _Form("a file of MATLAB", "vrts[validate]")


def table_of(files: Sequence[bytes], name: str, *, numbered: bool = False) -> LogTable | Diagnostic:
    """Return the table of a log, or what is wrong with it.

    Args:
        files: The bytes of its file, or of the files of a bag.
        name: As shown.
        numbered: Text without names of columns is read too; its columns are 1, 2, ...
    """
    if len(files) > 1 or any(data.startswith(BAGS) for data in files):
        return _read(BAG, name, lambda: _bag(files))
    data = b"".join(files)
    if data.startswith(MATLAB):
        return _read(MAT, name, lambda: _matlab(data))
    return read_table(data, name, numbered=numbered)


def _read(form: _Form, name: str, text: Callable[[], str]) -> LogTable | Diagnostic:
    try:
        return read_table(text().encode(), name)
    except ModuleNotFoundError:
        return error(
            LOG_UNREADABLE,
            f"`{name}` is {form.title}, and what reads that is not installed",
            help=(f"install it: pip install '{form.package}'",),
        )
    except Unreadable as problem:
        return error(
            LOG_UNREADABLE,
            f"`{name}` cannot be read as {form.title}",
            notes=(str(problem),),
        )


def _bag(files: Sequence[bytes]) -> str:
    from vrts.validate.log.bags.joint_states import bag_text  # mcap and rosbags are optional

    return bag_text(files)


def _matlab(data: bytes) -> str:
    from vrts.validate.log.matlab import matlab_text  # scipy is optional

    return matlab_text(data)
