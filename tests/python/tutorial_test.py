"""Runs the code of docs/python.md, block by block, in one interpreter: a page that lies fails."""

import pathlib
import re
import sys

page = pathlib.Path(sys.argv[1])
text = page.read_text()
blocks = [(m.start(), m.group(1)) for m in re.finditer(r"^```python\n(.*?)^```", text, re.M | re.S)]
assert len(blocks) >= 8, f"{page} has only {len(blocks)} blocks of code"
names: dict = {}
for at, code in blocks:
    line = text.count("\n", 0, at) + 1
    print(f"== {page.name}:{line}")
    exec(compile("\n" * line + code, str(page), "exec"), names)
