"""`vrts dispatch sign`."""

from pathlib import Path

import click

from vrts.cli.dispatch.serial_line import refuse_present
from vrts.cli.shared.console import guarded, say, write_file
from vrts.cli.shared.options import color_option

EPILOG = """\b
Examples:
  vrts dispatch sign pick.bundle --key ~/.ssh/id_ed25519
  vrts dispatch verify pick.bundle --signers allowed_signers
"""


@click.command(name="sign", epilog=EPILOG)
@click.argument("bundle", type=click.Path(path_type=Path))
@click.option(
    "--key",
    required=True,
    type=click.Path(path_type=Path),
    help="Your key of OpenSSH; or the public key, if an agent holds the private one.",
)
@color_option
@guarded
def command(bundle: Path, key: Path, color: str) -> None:
    """Sign a BUNDLE with a key of OpenSSH, in a file beside it: BUNDLE.sig.

    The bundle keeps its bytes. Only its certificates are checked first. `vrts dispatch verify`
    proves everything again: run it before you sign what somebody else has planned.
    """
    from vrts.dispatch.bundle import digest_of, read_bundle
    from vrts.dispatch.proofs import check_proofs
    from vrts.dispatch.verifying.signature import beside, signed
    from vrts.pipeline.files import read_bytes

    data, target = read_bytes(bundle), beside(bundle)
    refuse_present(target)
    for note in check_proofs(read_bundle(data)):
        say(f"note: {note}")
    write_file(target, signed(data, key.expanduser()))
    say(f"wrote {target}: signed {bundle.name} (sha256 {digest_of(data)[:12]})")
