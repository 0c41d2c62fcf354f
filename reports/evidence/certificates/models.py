"""Certificates for the real pairs at scale 1: the cost of making and following them."""

from __future__ import annotations

import gzip
import statistics
import tempfile
import time
from pathlib import Path

from minkref.certify.plane.certificate import Certificate
from minkref.reports.evidence.certificates.certified_cases import written
from minkref.reports.evidence.certificates.checkers import in_command, in_cpp, in_python, timed
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 0.6, 2)

REPETITIONS = Counts(1, 2, 5)
MOST_BYTES, MOST_SECONDS = 200e6, 600.0


def run(findings: Findings, size: Size) -> None:
    for names in (("monkey", "bird"), ("disc1", "neuron")):
        P, Q = (operand(name) for name in names)
        title = f"{P.name} + {Q.name} at 1"
        began = time.perf_counter()
        certificate = Certificate(P.set, Q.set)
        certificate.sum("1", passages=True)
        with tempfile.TemporaryDirectory() as folder:
            file = written(certificate, Path(folder), "it")
            made = time.perf_counter() - began
            packed = file.with_name("it.cert.json.gz")
            packed.write_bytes(gzip.compress(file.read_bytes()))
            plain, packed_size = file.stat().st_size, packed.stat().st_size
            in_c = [timed(in_cpp(), file) for _ in range(size.of(REPETITIONS))]
            in_p = timed(in_python(), file)
            unpacked = timed(in_command(), packed)
        refused = {verdict.why for verdict, _ in (*in_c, in_p, unpacked) if verdict.code}
        findings.law(f"{title}: verified by both checkers, and compressed by `minkref check`",
                     not refused, "all", "; ".join(refused) or "all")  # fmt: skip
        seconds = [spent for _, spent in in_c]
        most = made + max(seconds)
        findings.target(f"{title}: bytes", plain < MOST_BYTES, f"under {MOST_BYTES:,.0f}",
                        f"{plain:,} ({packed_size:,} compressed)")  # fmt: skip
        findings.target(f"{title}: seconds to make it and follow it in C++", most < MOST_SECONDS,
                        f"under {MOST_SECONDS:.0f}", f"{most:.2f}")  # fmt: skip
        sum_ = certificate.claims[0]
        findings.figures[title] = (
            f"{sum_['components']} components, {sum_['holes']} holes, "
            f"{len(certificate.claims) - 1} tight passages; made in {made:.2f} s; followed in C++ "
            f"in {statistics.median(seconds):.2f} s ({min(seconds):.2f} to {max(seconds):.2f} in "
            f"{size.of(REPETITIONS)}), in Python in {in_p[1]:.2f} s"
        )
    tell_absent(findings, "monkey", "bird", "neuron")
