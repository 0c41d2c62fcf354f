"""Headless Chromium through chromedriver (WebDriver over HTTP), with the standard library only."""

from __future__ import annotations

import base64
import json
import re
import shutil
import subprocess
import tempfile
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from minkref.signals import kill_group

PACKAGES = ("chromium", "chromium-driver")  # of Debian
SECONDS = 120.0  # for one answer
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
    missing = [name for name in ("chromium", "chromedriver") if shutil.which(name) is None]
    if not missing:
        return None
    return f"{' and '.join(missing)} not found: apt-get install {' '.join(PACKAGES)}"


class Browser:
    """A session with one window."""

    def __init__(self, port: int, session: str) -> None:
        self._session = f"http://127.0.0.1:{port}/session/{session}"

    def open(self, page: Path) -> None:
        self._post("/url", {"url": page.resolve().as_uri()})

    def run(self, script: str, *arguments: Any) -> Any:
        """The value that the body of a function returns in the page."""
        return self._post("/execute/sync", {"script": script, "args": list(arguments)})

    def prefer(self, colours: str) -> None:
        """`light` or `dark`."""
        feature = {"name": "prefers-color-scheme", "value": colours}
        parameters = {"cmd": "Emulation.setEmulatedMedia", "params": {"features": [feature]}}
        self._post("/goog/cdp/execute", parameters)

    def resize(self, width: int, height: int) -> None:
        self._post("/window/rect", {"width": width, "height": height})

    def viewport(self, width: int, height: int) -> None:
        """Also narrower than a window may be."""
        metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        parameters = {"cmd": "Emulation.setDeviceMetricsOverride", "params": metrics}
        self._post("/goog/cdp/execute", parameters)

    def screenshot(self, path: Path) -> None:
        path.write_bytes(base64.b64decode(_call("GET", f"{self._session}/screenshot")))

    def messages(self) -> list[str]:
        """What the page said on the console since the last call: errors, if anything."""
        return [entry["message"] for entry in self._post("/se/log", {"type": "browser"})]

    def close(self) -> None:
        _call("DELETE", self._session)

    def _post(self, path: str, body: dict[str, Any]) -> Any:
        return _call("POST", f"{self._session}{path}", body)


@contextmanager
def browser(width: int = 1440, height: int = 1000) -> Iterator[Browser]:
    """Ends what it started, whatever happens."""
    reason = absent()
    if reason is not None:
        raise RuntimeError(reason)
    with tempfile.TemporaryDirectory(prefix="minkref-browser-") as profile:
        driver = subprocess.Popen(
            ["chromedriver", "--port=0"],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            start_new_session=True,
        )
        try:
            port = _port(driver)
            options = [*OPTIONS, f"--user-data-dir={profile}", f"--window-size={width},{height}"]
            wanted = {
                "goog:chromeOptions": {"args": options, "binary": shutil.which("chromium")},
                "goog:loggingPrefs": {"browser": "WARNING"},
            }
            body = {"capabilities": {"alwaysMatch": wanted}}
            session = _call("POST", f"http://127.0.0.1:{port}/session", body)["sessionId"]
            window = Browser(port, session)
            try:
                yield window
            finally:
                window.close()
        finally:
            kill_group(driver.pid)
            driver.wait()


def _port(driver: subprocess.Popen[str]) -> int:
    assert driver.stdout is not None
    for line in driver.stdout:
        found = re.search(r"started successfully on port (\d+)", line)
        if found:
            return int(found[1])
    raise RuntimeError("chromedriver did not start")


def _call(method: str, url: str, body: dict[str, Any] | None = None) -> Any:
    text = None if body is None else json.dumps(body).encode()
    request = urllib.request.Request(url, text, {"Content-Type": "application/json"}, method=method)
    opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
    try:
        with opener.open(request, timeout=SECONDS) as answer:
            return json.load(answer)["value"]
    except urllib.error.HTTPError as error:
        value = json.load(error)["value"]
        raise RuntimeError(f"{value['error']}: {value['message']}") from error
