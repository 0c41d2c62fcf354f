"""Clusters of campaigns: what a file's table asks of the classes of Dask."""

from __future__ import annotations

import signal
from typing import Any

import pytest
from minkref.errors import Refusal
from minkref.fuzz.campaign.campaign_file import ClusterTable
from minkref.fuzz.campaign.clusters import CLUSTERS, class_of, joined, started


class Stub:
    """Stands for a cluster of Dask; no machine behind it."""

    def __init__(self, **options: Any) -> None:
        self.options, self.calls = options, list[Any]()

    def scale(self, number: int) -> None:
        self.calls.append(("scale", number))

    def adapt(self, **bounds: int) -> None:
        self.calls.append(("adapt", bounds))

    def close(self) -> None:
        self.calls.append("close")


def test_options_reach_the_class_as_they_are(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(CLUSTERS, "slurm", (f"{__name__}:Stub", "a package"))
    monkeypatch.setattr("minkref.fuzz.campaign.clusters.import_module", lambda _: _Here)
    options = {"queue": "long", "cores": 24, "job_extra_directives": ["-t 3"]}
    with started(ClusterTable(kind="slurm", workers=20, options=options), 2) as cluster:
        assert cluster.options == options
    assert cluster.calls == [("scale", 20), "close"]
    with started(ClusterTable(kind="slurm", adapt={"minimum": 1, "maximum": 9}), 2) as cluster:
        pass
    assert cluster.calls == [("adapt", {"minimum": 1, "maximum": 9}), "close"]


class _Here:
    Stub = Stub


def test_real_classes_write_the_jobs_of_slurm_and_pbs() -> None:
    """dask-jobqueue makes these scripts without the queue's programs. Ctrl-C stays ours."""
    handler = signal.getsignal(signal.SIGINT)
    for kind, line in (("slurm", "#SBATCH -p long"), ("pbs", "#PBS -q long")):
        job = class_of(ClusterTable(kind=kind)).job_cls
        script = job(None, queue="long", cores=4, memory="8GB").job_script()
        assert line in script and "distributed" in script
    assert signal.getsignal(signal.SIGINT) is handler


def test_absent_clusters_are_refused_by_name() -> None:
    for kind, words in (("kubernetes", "install dask-kubernetes"), ("slum", "did you mean slurm?")):
        with pytest.raises(Refusal) as refused:
            class_of(ClusterTable(kind=kind))
        assert words in refused.value.mend


def test_a_scheduler_that_does_not_answer_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("minkref.fuzz.campaign.clusters.CONNECT_SECONDS", 0.2)
    with pytest.raises(Refusal, match="no scheduler answers"), joined("tcp://127.0.0.1:9"):
        pass
