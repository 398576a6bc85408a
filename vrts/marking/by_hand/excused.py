"""What a result becomes where no mark is expected."""

import msgspec

from vrts.marking.result import Kind, Result


def excused_result(result: Result, why: str) -> Result:
    """Return the result of somebody who is excused: nothing is asked, lost or in doubt."""
    return msgspec.structs.replace(
        result,
        kind=Kind.EXCUSED,
        mark=None,
        lowest=None,
        review=(),
        ready=False,
        obstacles=(),
        cause=f"excused: {why}",
        hint=None,
        line=None,
        time_s=None,
        parts=None,
        losses=(),
        checks=(),
        stamps=(),
        more=0,
        mending=None,
    )
