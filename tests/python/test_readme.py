# SPDX-License-Identifier: BSL-1.0
"""What README.md and docs in text show in Python runs as it is shown."""

import pathlib
import re
import unittest

root = pathlib.Path(__file__).resolve().parents[2]


class Readme(unittest.TestCase):
    def test_blocks(self):
        blocks = re.findall(r"```python\n(.*?)```", (root / "README.md").read_text(encoding="utf-8"), re.DOTALL)
        self.assertGreaterEqual(len(blocks), 1)
        names = {}
        for block in blocks:
            exec(compile(block, "README.md", "exec"), names)
        self.assertLess(names["x"].residual(), 64)
        self.assertTrue(all(identity.holds for identity in names["proved"]))


if __name__ == "__main__":
    unittest.main()
