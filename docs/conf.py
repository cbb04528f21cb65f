"""Configuration of the site for Sphinx. docs/site.py sets the two variables and lays out the sources."""
import os

project = "libvblast_ss"
author = "the authors of libvblast_ss"
project_copyright = "Apache-2.0"
version = release = os.environ["VBSS_SITE_VERSION"]

extensions = ["myst_parser", "breathe"]
root_doc = "index"
nitpicky = False
highlight_language = "none"
suppress_warnings = ["myst.header"]  # some pages begin their sections at the third level

myst_heading_anchors = 5

breathe_projects = {"vblast_ss": os.environ["VBSS_SITE_XML"]}
breathe_default_project = "vblast_ss"
breathe_domain_by_extension = {"h": "c"}
c_id_attributes = ["VBSS_API"]

html_theme = "furo"
html_title = f"libvblast_ss {version}"
html_copy_source = False
html_show_sphinx = False
html_last_updated_fmt = ""
