"""A shared browser for all pages."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from minkref.reports.evidence.framework import browser as framework


@pytest.fixture(scope="session")
def started() -> Iterator[framework.Browser]:
    """The browser, which draws in space without a graphics card."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(framework, "OPTIONS", (*framework.OPTIONS, "--enable-unsafe-swiftshader"))
        with framework.browser(1200, 1000) as browser:
            yield browser


@pytest.fixture
def page_kept(started: framework.Browser) -> Iterator[framework.Browser]:
    """The browser with the previous test's page, for tests that share a page."""
    started.prefer("light")
    started.messages()
    yield started
    started.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


@pytest.fixture
def window(started: framework.Browser, page_kept: framework.Browser) -> framework.Browser:
    """The browser, without a page."""
    started.get("about:blank")
    started.messages()
    return started
