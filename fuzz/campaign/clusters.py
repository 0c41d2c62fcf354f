"""Workers for a campaign: in this process, behind a scheduler's address, or of a cluster that
Dask starts."""

from __future__ import annotations

import logging
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from importlib.util import find_spec
from typing import Any

from minkref.errors import Refusal, choice, message_of
from minkref.fuzz.campaign.campaign_file import ClusterTable

LOCAL = "local"
#: Kind: class, and the package that has it.
CLUSTERS = {
    "slurm": ("dask_jobqueue:SLURMCluster", "dask-jobqueue"),
    "pbs": ("dask_jobqueue:PBSCluster", "dask-jobqueue"),
    "sge": ("dask_jobqueue:SGECluster", "dask-jobqueue"),
    "lsf": ("dask_jobqueue:LSFCluster", "dask-jobqueue"),
    "kubernetes": ("dask_kubernetes.operator:KubeCluster", "dask-kubernetes"),
}
CONNECT_SECONDS = 20.0
LOOPBACK = "127.0.0.1:0"
NO_PAGES: dict[str, Any] = {
    "distributed.scheduler.http.routes": [],
    "distributed.worker.http.routes": [],
}


def has_dashboard() -> bool:
    """Tells whether Dask can draw its pages."""
    return find_spec("bokeh") is not None


def dask() -> Any:
    """Imports `distributed`. Refuses without it."""
    try:
        module = import_module("distributed")
    except ImportError as error:
        mend = 'install the extra: pip install "minkref[campaign]"'
        raise Refusal("distributed is not installed", "minkref campaign", mend) from error
    logging.getLogger("distributed").setLevel(logging.CRITICAL)
    return module


def class_of(table: ClusterTable) -> type[Any]:
    """Returns the class for a kind, or for `module:Class`. Refuses absent ones."""
    where = f"cluster, kind = {table.kind[:60]!r}"
    if table.kind not in CLUSTERS and ":" not in table.kind:
        mend = f"{choice(table.kind, [LOCAL, *CLUSTERS])}, or name module:Class"
        raise Refusal("there is no such cluster", where, mend)
    name, package = CLUSTERS.get(table.kind, (table.kind, table.kind.partition(":")[0]))
    module, _, attribute = name.partition(":")
    handler = signal.getsignal(signal.SIGINT)  # dask-jobqueue takes it, and Ctrl-C is ours
    try:
        found: type[Any] = getattr(import_module(module), attribute)
    except (ImportError, AttributeError) as error:
        raise Refusal(message_of(error), where, f"install {package}") from error
    finally:
        signal.signal(signal.SIGINT, handler)
    return found


@contextmanager
def started(table: ClusterTable, workers: int) -> Iterator[Any]:
    """Starts a cluster. A local cluster shares this process, one thread per worker process: other
    users and programs under test cannot hand it tasks."""
    module = dask()
    if table.kind == LOCAL:
        options: dict[str, Any] = {
            "n_workers": 1,
            "threads_per_worker": workers,
            "processes": False,
            "memory_limit": 0,
            "dashboard_address": LOOPBACK,
            "worker_dashboard_address": LOOPBACK,
            "silence_logs": logging.CRITICAL,
        }
        if not has_dashboard():  # Dask's server of pages stays empty, then
            import_module("dask.config").set(NO_PAGES)
        cluster = module.LocalCluster(**options | table.options)
    else:
        cluster = class_of(table)(**table.options)
    try:
        if table.adapt:
            cluster.adapt(**table.adapt)
        elif table.kind != LOCAL and table.workers is not None:
            cluster.scale(table.workers)
        yield cluster
    finally:
        cluster.close()


@contextmanager
def joined(place: Any) -> Iterator[Any]:
    """Connects to a cluster or a scheduler's address. Ctrl-C reaches this thread alone."""
    module = dask()
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, (signal.SIGINT,))
    try:
        try:
            client = module.Client(place, timeout=CONNECT_SECONDS, set_as_default=False)
        except (OSError, TimeoutError, ValueError, ImportError) as error:
            what = f"no scheduler answers: {message_of(error)}"
            raise Refusal(what, f"--scheduler {place}", "start it: dask scheduler") from error
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)
    try:
        yield client
    finally:
        client.close(timeout=2)
