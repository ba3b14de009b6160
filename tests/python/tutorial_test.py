"""Runs the Python of README.md and of every page of docs, block by block, a page in one namespace: a page that lies fails.

A block that the line `<!-- not run: REASON -->` stands before is left out; docs/developer_guide.md counts those.
"""

import os
import pathlib
import re
import sys
import tempfile

BLOCK = re.compile(r"^(?P<mark><!-- not run: .+ -->\n)?```python\n(?P<code>.*?)^```", re.M | re.S)


def run(page: pathlib.Path) -> int:
    """Runs the blocks of a page and returns how many there were."""
    text = page.read_text()
    names: dict = {}
    blocks = [block for block in BLOCK.finditer(text) if not block["mark"]]
    for block in blocks:
        line = text.count("\n", 0, block.start("code"))
        print(f"== {page.name}:{line}")
        exec(compile("\n" * line + block["code"], str(page), "exec"), names)
    return len(blocks)


pages = [pathlib.Path(name).resolve() for name in sys.argv[1:]]
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)  # What a block writes goes with it.
    counts = {page.name: run(page) for page in pages}
    os.chdir("/")
assert counts["python.md"] >= 8, f"python.md has only {counts['python.md']} blocks of code"
assert counts["README.md"] >= 1, "README.md has no block of Python"
