"""QR codes, as SVG pictures."""

from io import BytesIO

import segno


def qr_svg(text: str) -> bytes:
    """Return a picture of a text that a phone can read; its size is the page's business."""
    out = BytesIO()
    segno.make_qr(text, error="m").save(out, kind="svg", xmldecl=False, border=4, omitsize=True)
    return out.getvalue()
