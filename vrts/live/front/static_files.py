"""The browser's files: a fixed list, each with its ETag, compressed once."""

import gzip
import hashlib
from importlib.resources import files
from importlib.resources.abc import Traversable
from typing import Final, NamedTuple

from starlette.requests import Request
from starlette.responses import Response

from vrts.web.assets import served
from vrts.web.bundles import Bundles

TYPES: Final = {
    "css": "text/css; charset=utf-8",
    "html": "text/html; charset=utf-8",
    "js": "text/javascript; charset=utf-8",
    "json": "application/json",
    "png": "image/png",
    "svg": "image/svg+xml",
    "webmanifest": "application/manifest+json",
}
PAGE: Final = "live/index.html"
_SMALL = 1000  # bytes that are not worth compressing


class Content(NamedTuple):
    """Something that a browser may keep as long as its ETag is the same."""

    plain: bytes
    packed: bytes | None
    type: str
    tag: str

    def answer(self, request: Request, *, cache: str = "no-cache") -> Response:
        """Return the response: nothing when the browser has it already."""
        headers = {"etag": self.tag, "cache-control": cache, "vary": "accept-encoding"}
        if self.tag in request.headers.get("if-none-match", ""):
            return Response(status_code=304, headers=headers)
        packed = self.packed
        if packed is not None and "gzip" in request.headers.get("accept-encoding", ""):
            headers["content-encoding"] = "gzip"
            return Response(packed, headers=headers, media_type=self.type)
        return Response(self.plain, headers=headers, media_type=self.type)


def content(plain: bytes, kind: str) -> Content:
    """Return what is sent for some bytes."""
    tag = f'"{hashlib.sha256(plain).hexdigest()[:32]}"'
    worth = len(plain) > _SMALL and kind != "image/png"
    return Content(plain, gzip.compress(plain, 6, mtime=0) if worth else None, kind, tag)


class StaticFiles:
    """The files below `vrts/web` that a browser may ask for: nothing else has a name here."""

    def __init__(self, page: str = PAGE) -> None:
        """List them; what `page` needs comes in few files."""
        self._files = dict(_listed(files("vrts.web"), ""))
        self._bundles = Bundles(page)
        self._contents: dict[str, Content] = {}

    def find(self, path: str) -> Content | None:
        """Return a file by its path, None when there is none."""
        if path not in self._files and path != self._bundles.sheet:
            return None
        if path not in self._contents:
            self._contents[path] = self._read(path)
        return self._contents[path]

    def _read(self, path: str) -> Content:
        bundles = self._bundles
        if path == bundles.page:
            plain = bundles.html().encode()
        elif path == bundles.sheet:
            plain = bundles.css().encode()
        elif bundles.holds(path):
            plain = bundles.text(path).encode()
        elif path.endswith(".js"):
            plain = served(path).encode()
        else:
            plain = self._files[path].read_bytes()
        return content(plain, TYPES[path.rsplit(".", 1)[-1]])


def _listed(folder: Traversable, prefix: str) -> list[tuple[str, Traversable]]:
    found: list[tuple[str, Traversable]] = []
    for entry in folder.iterdir():
        name = f"{prefix}{entry.name}"
        if entry.is_dir():
            found += _listed(entry, f"{name}/")
        elif name.rsplit(".", 1)[-1] in TYPES:
            found.append((name, entry))
    return found
