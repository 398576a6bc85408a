"""What was found of a bundle, as text, as JSON, and on its sheet."""

import html
from collections.abc import Iterator
from typing import NamedTuple

from vrts import __version__
from vrts.dispatch.bundle import Bundle
from vrts.dispatch.planning.sheet.sheet import SIGNED_ELSEWHERE
from vrts.dispatch.verifying.again import Again
from vrts.dispatch.verifying.signature import Signature, Trust
from vrts.report.formats.json_text import json_text
from vrts.report.plain import one_line
from vrts.report.proof_words import counted

SCHEMA = "vrts.bundle-check/1"
SHORT = 12  # characters of a hash
OLD = "of an older format, which does not hold what it was planned from: plan again to prove it"


class Checked(NamedTuple):
    """What was found of a bundle that is sound, and whose certificates hold."""

    name: str  # of its file
    sha256: str
    bundle: Bundle
    notes: tuple[str, ...]  # on certificates that it has not
    again: Again | None  # None: it does not hold what it was planned from
    signature: Signature
    asks_for_signer: bool

    @property
    def is_proven(self) -> bool:
        """Whether everything was proven again."""
        return self.again is not None and self.again.is_same

    @property
    def is_signed(self) -> bool:
        """Whether the signature is as good as was asked for."""
        if self.asks_for_signer:
            return self.signature.trust is Trust.TRUSTED
        return self.signature.trust is not Trust.WRONG

    @property
    def holds(self) -> bool:
        """Whether it may be used."""
        return self.is_proven and self.is_signed


def checked_text(found: Checked) -> str:
    """Return lines for a terminal."""
    manifest = found.bundle.manifest
    head = (
        f"{one_line(found.name)}: {one_line(manifest.title)} for {manifest.profile}, "
        f"planned by vrts {one_line(manifest.vrts)} (sha256 {found.sha256[:SHORT]})"
    )
    lines = [
        head,
        _row(True, "files", f"{counted(len(manifest.files), 'file')}, each as its hash says"),
    ]
    for one in manifest.scenarios:
        if one.proof is not None:
            has = one.proof.file is not None
            lines.append(
                _row(has or None, "certificate", f"{one_line(one.scenario)}: {one.proof.summary}")
            )
    lines += [_row(False, "certificate", note) for note in found.notes if not manifest.asked]
    lines += list(_again(found))
    for waiver in manifest.waivers:
        named = f"{waiver.code}-{waiver.finding}" if waiver.finding else waiver.code
        lines.append(_row(None, "waived", f"{named} by {one_line(waiver.who)}: {waiver.reason}"))
    trust = found.signature.trust
    signed = None if trust is Trust.UNSIGNED and not found.asks_for_signer else found.is_signed
    lines.append(_row(signed, "signature", found.signature.words))
    lines.append("verified" if found.holds else "not verified")
    return "".join(f"{line}\n" for line in lines)


def checked_json(found: Checked) -> str:
    """Return a record for programs."""
    manifest, again, signature = found.bundle.manifest, found.again, found.signature
    return json_text(
        {
            "schema": SCHEMA,
            "vrts": __version__,
            "bundle": {
                "name": found.name,
                "sha256": found.sha256,
                "schema": manifest.schema,
                "planned_by": manifest.vrts,
                "title": manifest.title,
                "profile": manifest.profile,
            },
            "holds": found.holds,
            "planned_again": None
            if again is None
            else {
                "same_bytes": again.same_bytes,
                "refused": [f"{d.rule.code}: {d.headline}" for d in again.refused],
                "differences": list(again.differences),
            },
            "notes": list(found.notes),
            "waivers": [
                {"finding": f"{w.code}-{w.finding}", "who": w.who, "reason": w.reason}
                for w in manifest.waivers
            ],
            "signature": {
                "trust": signature.trust.value,
                "who": signature.who,
                "key": signature.key,
            },
        }
    )


def signed_sheet(found: Checked) -> str:
    """Return the operator's sheet, which now says who has signed, and that all was proven again."""
    said = f"{found.signature.words}. Proven again by vrts {__version__}; bundle {found.sha256}"
    return found.bundle.sheet.replace(html.escape(SIGNED_ELSEWHERE), html.escape(said))


def _again(found: Checked) -> Iterator[str]:
    again = found.again
    if again is None:
        yield _row(False, "planned", OLD)
    elif again.refused:
        count = counted(len(again.refused), "reason")
        yield _row(False, "planned", f"planned again, it is refused for {count}")
    elif again.differences:
        for each in again.differences:
            yield _row(False, "planned", f"planned again, {each}")
    else:
        how = "the same to the last byte" if again.same_bytes else "the same, in other words"
        yield _row(True, "planned", f"planned again: {how}; {_what(found.bundle)}")


def _what(bundle: Bundle) -> str:
    """Return what a plan proves, in short."""
    manifest = bundle.manifest
    parts = [counted(len(bundle.programs), "program"), counted(len(manifest.scenarios), "scenario")]
    parts += [f"every future {one.answer}" for one in dict.fromkeys(manifest.futures)][:1]
    return ", ".join((*parts, counted(len(manifest.margins), "margin")))


def _row(good: bool | None, title: str, words: str) -> str:
    sign = {True: "ok", False: "NO", None: "--"}[good]
    return f"  {sign}  {title:<12} {one_line(words)}"
