"""A record as a reader sees it: text for a terminal, LaTeX, HTML."""
