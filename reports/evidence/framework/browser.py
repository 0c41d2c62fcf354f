"""Headless Chromium, driven by Selenium."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from minkref.output.signals import kill_group
from selenium.webdriver import Chrome, ChromeOptions, ChromeService
from selenium.webdriver.common.options import BaseOptions

PROGRAMS = ("chromium", "chromedriver")
PACKAGES = ("chromium", "chromium-driver")  # of Debian
OPTIONS = (
    "--headless=new",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-dev-shm-usage",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--hide-scrollbars",
)


def absent() -> str | None:
    """Why no browser can be started; None if one can."""
    missing = [name for name in PROGRAMS if shutil.which(name) is None]
    if not missing:
        return None
    return f"{' and '.join(missing)} not found: apt-get install {' '.join(PACKAGES)}"


class Browser(Chrome):
    """A session with one window."""

    def open(self, page: Path) -> None:
        self.get(page.resolve().as_uri())

    def run(self, script: str, *arguments: Any) -> Any:
        """The value that a function with this body returns on the page. A script error raises
        JavascriptException."""
        return self.execute_script(script, *arguments)

    def prefer(self, colours: str) -> None:
        """`light` or `dark`."""
        feature = {"name": "prefers-color-scheme", "value": colours}
        self.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [feature]})

    def viewport(self, width: int, height: int) -> None:
        """Also narrower than a window may be."""
        metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        self.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)

    def messages(self) -> list[str]:
        """The page's console messages since the last call: errors, if any."""
        entries = self.get_log("browser")  # type: ignore[no-untyped-call]
        return [entry["message"] for entry in entries]


@contextmanager
def browser(width: int = 1440, height: int = 1000) -> Iterator[Browser]:
    """A browser; all its processes end on exit, whatever happens."""
    reason = absent()
    if reason is not None:
        raise RuntimeError(reason)
    # Both paths are given: Selenium looks for no program and loads none.
    chromium, chromedriver = (shutil.which(name) or "" for name in PROGRAMS)
    service = ChromeService(chromedriver, popen_kw={"start_new_session": True})
    with tempfile.TemporaryDirectory(prefix="minkref-browser-") as profile:
        options = ChromeOptions()
        options.binary_location = chromium
        options.set_capability("goog:loggingPrefs", {"browser": "WARNING"})
        # The driver is on this machine, whatever proxy the environment names.
        BaseOptions.ignore_local_proxy_environment_variables(options)
        for option in (*OPTIONS, f"--user-data-dir={profile}", f"--window-size={width},{height}"):
            options.add_argument(option)
        try:
            with Browser(options, service) as window:
                yield window
        finally:
            if service.process is not None:
                kill_group(service.process.pid)
                service.process.wait()
