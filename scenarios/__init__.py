"""What to try: scenario files, bundled rigs, and the code that loads and expands them."""
