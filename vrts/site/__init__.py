"""The manual as a site: pages made of what vrts knows beside those in `manual`, built by Sphinx.

In: the checkout, when a wheel is built or vrts is installed from its folder; nothing else calls it.
Out: `site/built` (HTML that works from plain files) and man pages. No network.
"""
