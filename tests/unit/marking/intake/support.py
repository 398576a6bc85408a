"""What the tests of the intake hand in: programs, documents, archives."""

import io
import zipfile
from collections.abc import Mapping
from pathlib import Path

PICK = b".PROGRAM pick()\n  MOVE part\n  CLOSEI\n.END\n"
OTHER = b".PROGRAM home()\n  READY\n.END\n"
STEPS = b"  MOVE part\n  CLOSEI\n  x = 1\n  DEPART 50\n"  # no header, yet VAL-II
PROSE = b"Dear Ms Berger,\nhere is my work.\nKind regards\n"
UTF16 = b"\xff\xfe" + PICK.decode().encode("utf-16-le")
WITH_MARK = b"\xef\xbb\xbf" + PICK.replace(b"\n", b"\r\n")
PDF = b"%PDF-1.7\n%\xe2\xe3\xcf\xd3\n"
RTF = b"{\\rtf1\\ansi .PROGRAM pick}"
JPEG = b"\xff\xd8\xff\xe0\x00\x10JFIF"
PNG = b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR"
HEIC = b"\x00\x00\x00\x18ftypheic\x00\x00\x00\x00"
FILM = b"\x00\x00\x00\x18ftypmp42\x00\x00\x00\x00"
HTML = b"<!DOCTYPE html>\n<html><body>.PROGRAM pick</body></html>"
OLD_DOC = b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(600)
RAR = b"Rar!\x1a\x07\x01\x00" + bytes(40)
TAR = b"pick.v2".ljust(257, b"\0") + b"ustar\x0000" + bytes(300)


def zipped(files: Mapping[str, bytes]) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(zipfile.ZipInfo(name), data, zipfile.ZIP_DEFLATED)
    return buffer.getvalue()


DOCX = zipped({"[Content_Types].xml": b"<x/>", "_rels/.rels": b"", "word/document.xml": b"<x/>"})
ODT = zipped({"mimetype": b"application/vnd.oasis", "content.xml": b"<x/>"})


def put(place: Path, files: Mapping[str, bytes]) -> Path:
    """Write files below a folder; a name that ends in `/` is a folder."""
    place.mkdir(parents=True, exist_ok=True)
    for name, data in files.items():
        path = place / name
        if name.endswith("/"):
            path.mkdir(parents=True, exist_ok=True)
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
    return place
