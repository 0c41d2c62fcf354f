"""A report about a finding, ready to send to the library's maintainers, as Markdown."""

from __future__ import annotations

from minkref.reports.findings.command import shown
from minkref.reports.findings.entry import Entry
from minkref.reports.findings.running import Ran

JUDGE = {
    "sum": "a point is in the sum of P and Q where P and the point less Q meet",
    "union": "a point is in the union where it is in one of the sets",
    "path": "two sets meet where the sum of one and the turned other has the origin",
    "offset": "a point is in the offset where its distance from the set is at most the radius",
    "inset": "a point is in the inset where its distance from the outside is at least the radius",
}


def letter(entry: Entry, ran: Ran | None = None) -> str:
    """The report; with the program's output, if it ran."""
    parts = [
        f"# {entry.library}: {entry.title}",
        f"`{entry.call}`, seen in {entry.library} {entry.versions}.",
        entry.answers,
        f"Right is: {entry.right}",
    ]
    if entry.witness is not None:
        point = ", ".join(entry.witness["point"])
        side = "in" if entry.witness["in_truth"] else "outside"
        said = f"The point ({point}) is {side} the right answer"
        if entry.verb == "path":
            meets = "meets" if entry.witness["in_truth"] else "does not meet"
            said = f"The part at ({point}) {meets} the obstacles"
        parts.append(f"{said}, decided in exact arithmetic: {JUDGE[entry.verb]}.")
        tolerance = entry.witness.get("tolerance", "0")
        if tolerance != "0":
            parts.append(f"So are all points nearer than {tolerance}, the tolerance that we allow.")
    text = entry.path.read_text(encoding="utf-8").rstrip()
    parts.append(f"This program uses {entry.library} alone:")
    parts.append(f"```{entry.language}\n{text}\n```")
    parts.append(f"It is run so:\n\n```sh\n{shown(entry)}\n```")
    if ran is not None and ran.said:
        parts.append(f"It prints:\n\n```\n{ran.said}\n```")
    if entry.issue is not None:
        parts.append(f"Known upstream: {entry.issue}")
    parts.append(f"Found by minkref: `{entry.reproduce}`")
    return "\n\n".join(parts) + "\n"
