# SPDX-License-Identifier: BSL-1.0
"""What a test needs of the machine: where that is not there it is skipped, and so ctest calls its file."""

import os
import shutil
import unittest

CC = os.environ.get("CC", "cc").split()
c_compiler = unittest.skipUnless(shutil.which(CC[0]), "there is no C compiler")
