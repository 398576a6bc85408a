"""What a file is, told by its first bytes."""

from typing import NamedTuple

HEAD = 4096  # bytes that are looked at


class Content(NamedTuple):
    """What a file is that is not plain text, and how its program is handed in well."""

    what: str  # "a PDF document"
    remedy: str


COPY = "copy the program into a plain editor, and hand in what it saves as `name.v2`"
TYPE = "type the program in a plain editor, and hand in what it saves as `name.v2`"
ITSELF = "hand in the program itself, `name.v2`"
PACK = "hand in the program itself, `name.v2`, or a zip of it"

WORD = Content("a Word document", COPY)
IMAGE = Content("a picture", TYPE)
FILM = Content("a film or a sound", ITSELF)

_STARTS: tuple[tuple[bytes, Content], ...] = (
    (b"%PDF", Content("a PDF document", COPY)),
    (b"{\\rtf", Content("a rich text document", COPY)),
    (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", Content("an old Office document", COPY)),
    (b"\x89PNG", IMAGE),
    (b"\xff\xd8\xff", IMAGE),
    (b"GIF8", IMAGE),
    (b"BM", IMAGE),
    (b"II*\x00", IMAGE),
    (b"MM\x00*", IMAGE),
    (b"\x1a\x45\xdf\xa3", FILM),
    (b"OggS", FILM),
    (b"ID3", FILM),
    (b"MZ", Content("a program for Windows", ITSELF)),
    (b"\x7fELF", Content("a program for Linux", ITSELF)),
    (b"L\x00\x00\x00\x01\x14\x02\x00", Content("a shortcut, without the file it leads to", ITSELF)),
    (b"[InternetShortcut]", Content("a link to a web page", ITSELF)),
    (b"SQLite format 3\x00", Content("a database", ITSELF)),
)
_ARCHIVES: tuple[tuple[bytes, Content], ...] = (
    (b"\x1f\x8b", Content("a gzip archive", PACK)),
    (b"BZh", Content("a bzip2 archive", PACK)),
    (b"\xfd7zXZ", Content("an xz archive", PACK)),
    (b"7z\xbc\xaf\x27\x1c", Content("a 7-Zip archive", PACK)),
    (b"Rar!", Content("a RAR archive", PACK)),
)
_TAR = Content("a tar archive", PACK)
_STILLS = (b"heic", b"heix", b"mif1", b"avif", b"hevc")  # brands of pictures in MP4 boxes
_WEB = (b"<!doctype html", b"<html")

ZIP = b"PK\x03\x04"
EMPTY_ZIP = b"PK\x05\x06"


def document(head: bytes) -> Content | None:
    """Return what a file is when its first bytes tell that it is not plain text."""
    for start, content in _STARTS:
        if head.startswith(start) and (start != b"BM" or head[6:10] == b"\0\0\0\0"):
            return content
    if head[4:8] == b"ftyp":
        return IMAGE if head[8:12] in _STILLS else FILM
    if head[:4] == b"RIFF":
        return IMAGE if head[8:12] == b"WEBP" else FILM
    start = head.removeprefix(b"\xef\xbb\xbf").lstrip()
    if start[:20].lower().startswith(_WEB):
        return Content("a web page", COPY)
    if start.startswith(b"{") and b"docs.google.com" in start[:400]:
        return Content("a link to a Google document", COPY)
    if b"%PDF-" in head[:1024] and b"\x00" in head:
        return Content("a PDF document", COPY)
    return None


def archive(head: bytes) -> Content | None:
    """Return what a file is when it is an archive other than a zip: these are not opened."""
    for start, content in _ARCHIVES:
        if head.startswith(start):
            return content
    return _TAR if head[257:262] == b"ustar" else None


def is_zip(head: bytes) -> bool:
    """Return whether a file begins as zips do, documents of offices among them."""
    return head.startswith((ZIP, EMPTY_ZIP))


def document_in_zip(names: tuple[str, ...]) -> Content | None:
    """Return what a zip is when it is a document; `names` are those of its members."""
    held = frozenset(names)
    starts = {name.split("/")[0] for name in names}
    if "[Content_Types].xml" in held:
        for folder, what in (("word", WORD.what), ("xl", "an Excel sheet"), ("ppt", "slides")):
            if folder in starts:
                return Content(what, COPY)
        return Content("an Office document", COPY)
    if "mimetype" in held and ("content.xml" in held or "META-INF" in starts):
        return Content("an OpenDocument text", COPY)
    if "Index/Document.iwa" in held or ("Index.zip" in held and "Metadata" in starts):
        return Content("a Pages document", COPY)
    if "vrun.json" in held:
        return Content("a saved run", ITSELF)
    return None
