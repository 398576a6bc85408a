from vrts.api.assessments import Assessment as Assessment
from vrts.api.causes import why as why
from vrts.api.certificates import certificate as certificate
from vrts.api.errors import VrtsError as VrtsError
from vrts.api.programs import compile as compile  # noqa: A004 -- `vrts.compile`, as the command
from vrts.api.proofs import prove as prove
from vrts.api.runs import Run as Run
from vrts.api.runs import run as run
from vrts.api.scenes import scene as scene
from vrts.api.scenes import task as task
from vrts.api.verifying import mark as mark
from vrts.api.verifying import verify as verify

__version__: str
__all__ = [
    "Assessment",
    "Run",
    "VrtsError",
    "certificate",
    "compile",
    "mark",
    "prove",
    "run",
    "scene",
    "task",
    "verify",
    "why",
]
