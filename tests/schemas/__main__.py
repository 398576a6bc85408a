"""`python -m tests.schemas` writes the schemas of input files anew."""

from tests.schemas.written import FOLDER, written

for kind, text in written().items():
    (FOLDER / f"{kind}.schema.json").write_text(text, "utf-8")
    print(f"vrts/schemas/{kind}.schema.json")
