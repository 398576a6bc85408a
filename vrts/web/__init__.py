"""Browser code: plain ES modules and style sheets, and the Python that puts them into one page."""
