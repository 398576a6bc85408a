"""A bundle: one file with everything that goes to a controller, and what was verified about it.

It is a zip of `manifest.json`, `sheet.html`, `programs/NAME.v2` for every program, of
`locations.lc`, `reals.rv` and `strings.st` as far as there are such data, of a certificate
`proofs/NUMBER.cert` for every scenario, and of the files in `given/` that it was planned from. The
same content gives the same bytes. A bundle is opened without trusting it: names, sizes, hashes and
characters are checked before anything is believed. That it is sound does not show who has made it.
"""

import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType

import msgspec

from vrts.base.diagnostic import Rule, error
from vrts.base.source import SourceFile
from vrts.base.zips import BadZip, Unpacker, packed
from vrts.dispatch.manifest import SCHEMA, WITHOUT_PROOFS, Manifest, Member
from vrts.pipeline.refused import Refused

BAD_BUNDLE = Rule("V800", "bad-bundle")

MANIFEST = "manifest.json"
SHEET = "sheet.html"
LOCATIONS, REALS, STRINGS = "locations.lc", "reals.rv", "strings.st"
MOST_BYTES = 20_000_000  # of all files, unpacked
MOST_CONTENTS = 1_000_000  # bytes of the table of contents
MODE = 0o644  # of the files
_PROGRAM = re.compile(r"programs/([a-z][a-z0-9._]{0,30})\.v2")
_PROOF = re.compile(r"proofs/[1-9][0-9]{0,3}\.cert")
_GIVEN = re.compile(r"given/[a-z]{1,20}(-[a-z]{1,20})?(-[1-9][0-9]{0,3})?")
_TITLES = {LOCATIONS: ".LOCATIONS", REALS: ".REALS", STRINGS: ".STRINGS"}
_TEXT = re.compile(r"[ -~\n]*\n")  # printable 7-bit ASCII in whole lines
_ROW = re.compile(r"(\S+) +(\S.*)")
NO_MEMBERS: tuple[Member, ...] = ()
NO_FILES: Mapping[str, bytes] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class Bundle:
    """Programs and data as they are to be sent, and what was verified about them."""

    manifest: Manifest
    programs: Mapping[str, str]  # canonical text by name, from .PROGRAM to .END
    locations: str  # .LOCATIONS section as the controller will hold it; "" where there are none
    reals: str  # .REALS section
    strings: str  # .STRINGS section
    sheet: str  # the operator's page, HTML
    # certificates by name of the file
    proofs: Mapping[str, bytes] = field(default_factory=lambda: NO_FILES)
    # what it was planned from, by name of the file
    given: Mapping[str, bytes] = field(default_factory=lambda: NO_FILES)

    @property
    def profile(self) -> str:
        """Name of the profile it was planned for."""
        return self.manifest.profile


def rows(section: str) -> tuple[tuple[str, str], ...]:
    """Return names, with subscripts, and values as printed, of a data section of a bundle."""
    found = [_ROW.fullmatch(line) for line in section.splitlines()[1:-1]]
    return tuple((row[1], row[2]) for row in found if row is not None)


def bundle_bytes(bundle: Bundle) -> bytes:
    """Return the file of a bundle; its manifest gains the list of files."""
    texts = {name: text.encode() for name, text in _texts(bundle).items()}
    members = dict(sorted({**texts, **bundle.proofs, **bundle.given}.items()))
    files = tuple(Member(name, digest_of(data), len(data)) for name, data in members.items())
    manifest = msgspec.structs.replace(bundle.manifest, files=files)
    said = msgspec.json.format(msgspec.json.encode(manifest), indent=1) + b"\n"
    return packed({MANIFEST: said, **members}, MODE)


def read_bundle(data: bytes) -> Bundle:
    """Return the bundle that a file holds.

    Raises:
        Refused: It is none, is damaged, or was changed.
    """
    try:
        zipped = Unpacker(data, contents=MOST_CONTENTS)
        _check_contents(zipped)
        manifest = msgspec.json.decode(zipped.read(MANIFEST), type=Manifest)
        held = {member.name: _member(zipped, member) for member in manifest.files}
    except BadZip as problem:
        named = f" (`{problem.member[:60]}`)" if problem.member else ""
        raise bad_bundle(f"its zip file is {problem.flaw.value}{named}") from problem
    except msgspec.MsgspecError as problem:
        raise bad_bundle(f"`{MANIFEST}`: {problem}") from problem
    if [MANIFEST, *held] != list(zipped.sizes):
        raise bad_bundle("its files are not those that its manifest lists")
    proofs = {name: data for name, data in held.items() if _PROOF.fullmatch(name)}
    _check_proofs(manifest, proofs)
    given = {name: data for name, data in held.items() if _GIVEN.fullmatch(name)}
    if (manifest.schema == SCHEMA) != (manifest.asked is not None) or (
        given and manifest.asked is None
    ):
        raise bad_bundle("it does not say what it was planned from")
    own = proofs.keys() | given.keys()
    texts = {name: _text(name, data) for name, data in held.items() if name not in own}
    if SHEET not in texts:
        raise bad_bundle(f"`{SHEET}` is missing")
    programs = {
        found[1]: _program(found[1], text)
        for name, text in texts.items()
        if (found := _PROGRAM.fullmatch(name)) is not None
    }
    if manifest.entry not in programs:
        raise bad_bundle("the program to execute is not in it")
    data_texts = {name: _section(name, texts.get(name, "")) for name in _TITLES}
    return Bundle(
        manifest,
        MappingProxyType(programs),
        data_texts[LOCATIONS],
        data_texts[REALS],
        data_texts[STRINGS],
        texts[SHEET],
        MappingProxyType(proofs),
        MappingProxyType(given),
    )


def files_of(programs: Mapping[str, str], entry: str, *sections: str) -> tuple[SourceFile, ...]:
    """Return what a controller is given as files, in the order in which they are read.

    Args:
        programs: Texts by name.
        entry: The program to execute: it is the first.
        sections: Locations, reals and strings; "" where there are none.
    """
    names = [entry, *(name for name in programs if name != entry)]
    data = [SourceFile(name, text) for name, text in zip(_TITLES, sections, strict=True) if text]
    return (*(SourceFile(f"programs/{name}.v2", programs[name]) for name in names), *data)


def proof_name(number: int) -> str:
    """Return the name of the certificate of a scenario; the first is number 1."""
    return f"proofs/{number}.cert"


def with_sheet(bundle: Bundle, sheet: str) -> Bundle:
    """Return a bundle with another sheet."""
    return replace(bundle, sheet=sheet)


def digest_of(data: bytes) -> str:
    """Return the sha256 by which files are named."""
    return hashlib.sha256(data).hexdigest()


def content_digest(bundle: Bundle) -> str:
    """Return the sha256 of what is sent: programs and data, each with its name."""
    sent = {name: text for name, text in _texts(bundle).items() if name != SHEET}
    whole = "".join(f"{name}\n{text}" for name, text in sorted(sent.items()))
    return digest_of(whole.encode())


def bad_bundle(why: str) -> Refused:
    """Return what to raise for a file that is no sound bundle."""
    headline = f"this is no bundle of `vrts dispatch plan`: {why[:200]}"
    remedy = "copy the file again, or plan again; a bundle is not for editing"
    return Refused((error(BAD_BUNDLE, headline, help=(remedy,)),))


def _texts(bundle: Bundle) -> dict[str, str]:
    texts = {f"programs/{name}.v2": text for name, text in bundle.programs.items()}
    sections = {LOCATIONS: bundle.locations, REALS: bundle.reals, STRINGS: bundle.strings}
    return {**texts, **{n: text for n, text in sections.items() if text}, SHEET: bundle.sheet}


def _check_contents(zipped: Unpacker) -> None:
    for name, member in zipped.members.items():
        known = name in (MANIFEST, SHEET, *_TITLES) or any(
            form.fullmatch(name) is not None for form in (_PROGRAM, _PROOF, _GIVEN)
        )
        if not known or not member.plain:
            raise bad_bundle(f"its file `{name[:60]!a}` does not belong there")
    if MANIFEST not in zipped.sizes:
        raise bad_bundle(f"`{MANIFEST}` is missing")
    total = sum(zipped.sizes.values())
    if total > MOST_BYTES:
        raise bad_bundle(f"it unpacks to {total:,} bytes, the limit is {MOST_BYTES:,}")


def _check_proofs(manifest: Manifest, proofs: Mapping[str, bytes]) -> None:
    """Refuse certificates that are missing, or that no scenario names."""
    wanted: list[str] = []
    for number, one in enumerate(manifest.scenarios, 1):
        if manifest.schema != WITHOUT_PROOFS and one.proof is None:
            raise bad_bundle(f"it says nothing of the certificate of scenario {number}")
        if one.proof is not None and one.proof.file is not None:
            if one.proof.file != proof_name(number) or one.proof.file not in proofs:
                raise bad_bundle(f"the certificate of scenario {number} is missing")
            wanted.append(one.proof.file)
    strange = sorted(proofs.keys() - set(wanted))
    if strange:
        raise bad_bundle(f"no scenario names its certificate `{strange[0]}`")


def _member(zipped: Unpacker, member: Member) -> bytes:
    if member.name == MANIFEST or zipped.sizes.get(member.name) != member.bytes:
        raise bad_bundle(f"`{member.name!a}` is not there, or has another length")
    data = zipped.read(member.name)
    if digest_of(data) != member.sha256:
        raise bad_bundle(f"`{member.name}` was changed: its hash is another")
    return data


def _text(name: str, data: bytes) -> str:
    try:
        return data.decode()
    except UnicodeDecodeError as problem:
        raise bad_bundle(f"`{name}` is no text") from problem


def _program(name: str, text: str) -> str:
    lines = _lines(f"programs/{name}.v2", text)
    heads = [line for line in lines if line.startswith(".")]
    begins = re.fullmatch(rf"\.PROGRAM {re.escape(name)}(\W.*)?", lines[0]) is not None
    if not begins or not lines[-1].startswith(".END") or len(heads) != 2:
        raise bad_bundle(f"`programs/{name}.v2` is not one program of that name")
    return text


def _section(name: str, text: str) -> str:
    if not text:
        return ""
    lines = _lines(name, text)
    sound = lines[0] == _TITLES[name] and lines[-1] == ".END" and len(lines) > 2
    if not sound or any(_ROW.fullmatch(line) is None for line in lines[1:-1]):
        raise bad_bundle(f"`{name}` is not one section {_TITLES[name]}")
    return text


def _lines(name: str, text: str) -> list[str]:
    if _TEXT.fullmatch(text) is None:
        raise bad_bundle(f"`{name}` holds more than lines of 7-bit ASCII")
    return text.split("\n")[:-1]
