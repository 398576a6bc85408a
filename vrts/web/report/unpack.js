// Before the modules of a page: it holds them deflated, and here they become an import map.
// Not a module itself, as none may be loaded before there is an import map.

(async () => {
  const held = /** @type {HTMLElement} */ (document.getElementById("modules"));
  const bytes = Uint8Array.from(atob(held.textContent ?? ""), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  /** @type {{entry: string, sources: Record<string, string>}} */
  const { entry, sources } = await new Response(stream).json();
  const map = document.createElement("script");
  map.type = "importmap";
  map.textContent = JSON.stringify({
    imports: Object.fromEntries(Object.entries(sources).map(([name, source]) => [name, `data:text/javascript,${encodeURIComponent(source)}`])),
  });
  document.head.append(map);
  held.remove();
  await import(entry);
})().catch((problem) => {
  /** @type {HTMLElement} */ (document.getElementById("no-replay")).hidden = false;
  throw problem;
});
