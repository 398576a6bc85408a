"""Addresses of what belongs to one submission, as seen from a page in `staff`."""

from urllib.parse import quote

from vrts.marking.layout import STUDENTS
from vrts.marking.submission.report_files import REPORT


def staff_report(identifier: str) -> str:
    """Return the address of the report for those who mark."""
    return f"{STUDENTS}/{quote(identifier, safe='')}/{REPORT}"


def sent_report(identifier: str) -> str:
    """Return the address of the report that the student gets."""
    return f"../{staff_report(identifier)}"
