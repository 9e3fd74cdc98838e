"""Exudyn: fast build, silent, without stored user settings. ImportError where it is not installed."""

import contextlib
import io
import os
import sys

# Must be set before the first import: the build without range checks, no settings from the user's folder.
sys.exudynFast = True
os.environ["EXUDYN_NO_USER_SETTINGS"] = "1"

with contextlib.redirect_stdout(io.StringIO()):
    import exudyn as exu
    from exudyn import itemInterface as item

exu.config.printToConsole = False
exu.config.suppressWarnings = True

VERSION = exu.config.Version()
IS_FAST = "exudyn.exudynCPPfast" in sys.modules

__all__ = ["IS_FAST", "VERSION", "exu", "item"]
