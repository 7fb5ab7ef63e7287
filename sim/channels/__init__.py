"""Truth beyond poses, on request: what each pixel shows, how far it is, where it goes, who else sees it."""
