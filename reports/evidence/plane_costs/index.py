"""The index of all scales: build, size and queries against CGAL and the floor."""

from __future__ import annotations

from typing import Any

from minkref.reports.bench import index
from minkref.reports.evidence.framework.part import Findings, Minutes, Size

MINUTES = Minutes(None, 0.7, 6)
ALONE = True
SEED = 1

# For each large pair: the ratio of CGAL to a query, by form; builds, counted as CGAL sums or
# seconds; bytes.
RATIOS = {
    "monkey + bird": {"double": 100_000, "homogeneous": 3_000, "rational": 500},
    "neuron + disc1": {"double": 10_000},
    "neuron + disc5": {"double": 10_000},
}
MOST_CALLS, HOPED_CALLS = 15, 5
MOST_SECONDS, HOPED_SECONDS = 2.0, 0.5
MOST_BYTES = 10_000_000
MOST_QUERIES = 3  # queries of a lazy index from which on CGAL's sums take longer
MEAN_RATIO = 1000  # homogeneous, over the 25 small pairs


def run(findings: Findings, size: Size) -> None:
    table = index.run(
        size is not Size.FULL, SEED, lambda text: print(text, flush=True), lambda: None
    )
    for note in table.notes:
        findings.note(note)
    findings.none("sums that differ from the static ones", table.wrong)
    for name, row in ((_asked(row["name"]), row) for row in table.rows if not row["small"]):
        for form, wanted in RATIOS.get(name, {}).items():
            ratio = row["forms"][form]["cgal_ratio"]
            findings.target(f"{row['name']}: CGAL over a query, {form}",
                            ratio is not None and ratio >= wanted, f"{wanted:,}",
                            "-" if ratio is None else f"{ratio:,.0f}")  # fmt: skip
        if name == "monkey + bird":
            calls = row["build_in_cgal_calls"]
            for most in (MOST_CALLS, HOPED_CALLS):
                met = calls is not None and calls <= most
                findings.target(f"{row['name']}: build in CGAL's sums", met,
                                f"at most {most}", _or_dash(calls, ".1f"))  # fmt: skip
            findings.target(f"{row['name']}: bytes", row["bytes"] < MOST_BYTES,
                            f"under {MOST_BYTES:,}", f"{row['bytes']:,}")  # fmt: skip
        elif name in RATIOS:
            for seconds in (MOST_SECONDS, HOPED_SECONDS):
                findings.target(f"{row['name']}: seconds to build", row["build_seconds"] <= seconds,
                                f"at most {seconds}", f"{row['build_seconds']:.2f}")  # fmt: skip
        findings.note(_sentence(row))
    pays = [(row["name"], row["lazy"]["pays_from"]) for row in table.rows]
    late = [name for name, count in pays if count is None or count > MOST_QUERIES]
    findings.target(f"pairs whose lazy index pays later than from {MOST_QUERIES} sums of CGAL on",
                    not late, "none", ", ".join(late) or "none")  # fmt: skip
    mean = table.mean_ratio("homogeneous")
    findings.target("mean over the 25 pairs of CGAL over a query, homogeneous",
                    mean is not None and mean >= MEAN_RATIO, f"{MEAN_RATIO:,}",
                    "not all pairs were timed" if mean is None else f"{mean:,.0f}")  # fmt: skip
    for form in ("double", "rational", "track"):
        told = table.mean_ratio(form)
        if told is not None:
            findings.note(f"mean over the 25 pairs of CGAL over a query, {form}: {told:,.0f}")
    findings.figures = {"rows": table.rows}


def _or_dash(value: float | None, form: str) -> str:
    return "-" if value is None else format(value, form)


def _asked(name: str) -> str:
    """The pair that a look-alike stands for."""
    for alike, model in (("glyph1204", "monkey"), ("glyph275", "bird"), ("cells1815", "neuron")):
        name = name.replace(alike, model)
    return name


def _sentence(row: dict[str, Any]) -> str:
    told = []
    for form in ("double", "homogeneous", "rational"):
        own = row["forms"][form]
        query, ratio, floor = own["query"], own["cgal_ratio"], own["floor_ratio"]
        against = "no CGAL"
        if ratio is not None:
            against = f"CGAL {ratio:,.0f} times, pays from {own['break_even']}"
        told.append(
            f"{form} {query['mean'] * 1e6:.1f} us (quartiles {query['lower'] * 1e6:.1f} to "
            f"{query['upper'] * 1e6:.1f}; {floor:.1f} floors; {against})"
        )
    return (
        f"{row['name']}: {row['edges']:,} edges, {row['boundary_events']:,} events, "
        f"{row['vertices']:,.0f} vertices; built in {row['build_seconds']:.2f} s, "
        f"{row['bytes'] / 1e6:.1f} MB; {'; '.join(told)}"
    )
