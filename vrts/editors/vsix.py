"""The extension for VS Code as a `.vsix` file: a zip with a manifest, reproducible."""

import json
import zipfile
from importlib.resources import files
from importlib.resources.abc import Traversable
from io import BytesIO
from pathlib import Path
from typing import Any
from xml.sax.saxutils import escape, quoteattr

from vrts import __version__
from vrts.schemas import FILES, FOLDER
from vrts.web.assets import asset, closure

GRAMMAR = "val2.tmLanguage.json"
BESIDE = "beside/main.js"  # the module of the panel beside the text
_BESIDE_TOO = ("beside/page.html", "beside/beside.css", "report/replay.html")
_SHEETS = ("report/base.css", "report/page.css")
_MADE = (2000, 1, 1, 0, 0, 0)
_TYPES = {
    "json": "application/json",
    "js": "application/javascript",
    "md": "text/markdown",
    "png": "image/png",
    "html": "text/html",
    "css": "text/css",
    "txt": "text/plain",
    "toml": "text/plain",
    "vsixmanifest": "text/xml",
}


def vsix() -> bytes:
    """Return the file, as VS Code installs it (`code --install-extension vrts.vsix`)."""
    editors = files("vrts.editors")
    contents = dict(_files(editors.joinpath("vscode"), "extension"))
    package = json.loads(contents["extension/package.json"])
    package["version"] = version()
    package["contributes"]["tomlValidation"] = toml_validation(FOLDER)
    contents["extension/package.json"] = json.dumps(package, indent=2).encode() + b"\n"
    for path in (*closure(BESIDE), *_BESIDE_TOO, *_SHEETS):
        contents[f"extension/web/{path}"] = asset(path).encode()
    contents["extension/web/vendor/LICENSE-three.txt"] = asset("vendor/LICENSE-three").encode()
    contents[f"extension/syntaxes/{GRAMMAR}"] = editors.joinpath(GRAMMAR).read_bytes()
    contents["extension.vsixmanifest"] = _manifest(package).encode()
    contents["[Content_Types].xml"] = _content_types().encode()
    data = BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(contents):
            info = zipfile.ZipInfo(name, _MADE)
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = 0o644 << 16
            archive.writestr(info, contents[name])
    return data.getvalue()


def toml_validation(folder: Path) -> list[dict[str, object]]:
    """Return which schema checks which file, as the extension Even Better TOML takes it.

    It wants an address and no path within our extension: so it is that of the vrts that writes.

    Args:
        folder: That of the schemas.
    """
    return [
        {"fileMatch": list(names), "url": (folder / f"{kind}.schema.json").resolve().as_uri()}
        for kind, names in FILES.items()
    ]


def version() -> str:
    """Return the version of vrts as extensions have it: three numbers."""
    numbers = [part for part in __version__.split("+")[0].split(".")[:3] if part.isdigit()]
    return ".".join((*numbers, "0", "0", "0")[:3])


def _files(folder: Traversable, name: str) -> list[tuple[str, bytes]]:
    found: list[tuple[str, bytes]] = []
    for item in folder.iterdir():
        path = f"{name}/{item.name}"
        if item.is_dir():
            found += _files(item, path)
        else:
            found.append((path, item.read_bytes()))
    return found


def _manifest(package: dict[str, Any]) -> str:
    name, publisher = (quoteattr(str(package[key])) for key in ("name", "publisher"))
    code = quoteattr(package["engines"]["vscode"])
    title, about = (escape(str(package[key])) for key in ("displayName", "description"))
    tags = escape(",".join(package["keywords"]))
    banner = package["galleryBanner"]
    kind = "Microsoft.VisualStudio"
    return f"""<?xml version="1.0" encoding="utf-8"?>
<PackageManifest Version="2.0.0" xmlns="http://schemas.microsoft.com/developer/vsx-schema/2011">
  <Metadata>
    <Identity Language="en-US" Id={name} Version="{version()}" Publisher={publisher}/>
    <DisplayName>{title}</DisplayName>
    <Description xml:space="preserve">{about}</Description>
    <Tags>{tags}</Tags>
    <Categories>Programming Languages,Debuggers,Snippets</Categories>
    <Properties>
      <Property Id="{kind}.Code.Engine" Value={code}/>
      <Property Id="{kind}.Code.ExtensionKind" Value="workspace"/>
      <Property Id="{kind}.Services.Branding.Color" Value={quoteattr(banner["color"])}/>
      <Property Id="{kind}.Services.Branding.Theme" Value={quoteattr(banner["theme"])}/>
    </Properties>
    <License>extension/LICENSE.txt</License>
    <Icon>extension/icon.png</Icon>
  </Metadata>
  <Installation><InstallationTarget Id="{kind}.Code"/></Installation>
  <Dependencies/>
  <Assets>
    <Asset Type="{kind}.Code.Manifest" Path="extension/package.json" Addressable="true"/>
    <Asset Type="{kind}.Services.Content.Details" Path="extension/README.md" Addressable="true"/>
    <Asset Type="{kind}.Services.Content.License" Path="extension/LICENSE.txt" Addressable="true"/>
    <Asset Type="{kind}.Services.Icons.Default" Path="extension/icon.png" Addressable="true"/>
  </Assets>
</PackageManifest>
"""


def _content_types() -> str:
    rows = "".join(
        f'<Default Extension=".{end}" ContentType="{kind}"/>' for end, kind in _TYPES.items()
    )
    return (
        '<?xml version="1.0" encoding="utf-8"?>\n'
        f'<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">{rows}</Types>\n'
    )
