"""The page as one HTML file that needs nothing else."""

from __future__ import annotations

from typing import Any

from minkref.output.terminal import escaped
from minkref.page.template import json_for_script, page_template


def page(P: str, Q: str, data: dict[str, Any]) -> str:
    """The text of the file. `data` is what `picture` gives; P and Q are the operands' names."""
    template, usual = page_template("plane", "sum")
    eroded = bool(data.get("erode"))
    shown = (f"outside of {P}", f"-{Q}") if eroded else (P, Q)
    return template.render(
        P=escaped(P),
        Q=escaped(Q),
        sign="⊖" if eroded else "⊕",
        shown_P=escaped(shown[0]),
        shown_Q=escaped(shown[1]),
        data=json_for_script(data),
        **usual,
    )
