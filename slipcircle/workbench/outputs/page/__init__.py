"""Live page of a slide: Python modules, and the page's HTML, CSS and JavaScript."""
