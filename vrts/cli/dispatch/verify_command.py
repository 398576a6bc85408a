"""`vrts dispatch verify`."""

import sys
from pathlib import Path

import click

from vrts.cli.shared.console import HOLDS, WRONG, guarded, out, say, show_diagnostics, write_file
from vrts.cli.shared.options import color_option, file_option, form_option, jobs_option

EPILOG = """\b
Examples:
  vrts dispatch verify pick.bundle
  vrts dispatch verify pick.bundle --signers allowed_signers --sheet pick.html
  vrts dispatch verify pick.bundle --format json
"""


@click.command(name="verify", epilog=EPILOG)
@click.argument("bundle", type=click.Path(path_type=Path))
@file_option("--signers", help="File of allowed signers; one of them has to have signed.")
@file_option("--signature", help="The signature; without it BUNDLE.sig, if that is there.")
@file_option("--sheet", help="Write the operator's sheet, which says who has signed.")
@form_option("full", "json")
@jobs_option("Processes at a time; without it one per core.")
@color_option
@guarded
def command(
    bundle: Path,
    signers: Path | None,
    signature: Path | None,
    sheet: Path | None,
    form: str,
    jobs: int | None,
    color: str,
) -> None:
    """Prove everything in a BUNDLE again, and say who has signed it.

    Every file is compared with its hash, every certificate is checked, and the plan is made again
    from the files that the bundle came with: program and data as the controller prints them, each
    scenario, every future, margins, dry run and sheet. The same vrts has to make the same bytes.

    A signature is BUNDLE.sig, as `vrts dispatch sign` writes it. It counts only with a file of
    allowed signers: lines with a name and a public key, as for `ssh-keygen -Y verify`.

    Exit status 1 when something is not proven again, when a signature is wrong, or when --signers
    is given and none of them has signed.
    """
    from vrts.cli.shared.cores import one_thread_each, workers_of

    one_thread_each()
    from vrts.dispatch.bundle import digest_of, read_bundle
    from vrts.dispatch.proofs import check_proofs
    from vrts.dispatch.verifying.again import planned_again
    from vrts.dispatch.verifying.signature import beside, signature_of
    from vrts.dispatch.verifying.told import Checked, checked_json, checked_text, signed_sheet
    from vrts.pipeline.files import read_bytes

    data = read_bytes(bundle)
    who = signature_of(data, signature or beside(bundle), signers)
    read = read_bundle(data)
    notes = check_proofs(read)
    again = None
    if read.manifest.asked is not None:
        again = planned_again(read, data, workers_of(jobs))
    found = Checked(
        bundle.name, digest_of(data), read, notes, again, who, asks_for_signer=signers is not None
    )
    if again is not None:
        show_diagnostics(again.refused, color)
    out(checked_json(found) if form == "json" else checked_text(found), end=form == "json")
    if not found.holds:
        sys.exit(WRONG)
    if sheet is not None:
        write_file(sheet, signed_sheet(found).encode())
        say(f"wrote {sheet}, to be printed")
    sys.exit(HOLDS)
