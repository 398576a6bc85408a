// Of a page in a frame of a notebook: its links scroll. Their targets would be looked for at the
// address of the notebook, which would open in the frame. Not a module: it needs none.

for (const link of document.querySelectorAll('a[href^="#"]')) {
  const place = document.getElementById((link.getAttribute("href") ?? "").slice(1));
  link.addEventListener("click", (event) => {
    event.preventDefault();
    place?.scrollIntoView({ block: "center" });
  });
  if (!place) link.removeAttribute("href"); // that part of the page is not here
}
