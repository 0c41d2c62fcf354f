"""Runs a campaign and prints results."""

from __future__ import annotations

import os
import re
import signal
import sys
import threading
import time
from collections.abc import Mapping
from contextlib import ExitStack, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import typer
from minkref.cli.settings import target_from
from minkref.errors import Refusal
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.campaign.campaign_file import CampaignFile, read_campaign
from minkref.fuzz.campaign.chunks import Plan, only_settings
from minkref.fuzz.campaign.clusters import dask, has_dashboard, joined, started
from minkref.fuzz.campaign.engine import Drive, Goal, SchedulerLost
from minkref.fuzz.campaign.folder import FORMAT, campaign_id, head_path, write_json
from minkref.fuzz.campaign.judging import HELD, Work
from minkref.fuzz.campaign.tally import Tally
from minkref.fuzz.isolation.isolation import Isolation, choose
from minkref.fuzz.ledgers.compaction import compact_if_due
from minkref.fuzz.run.case_list import CaseList
from minkref.fuzz.run.catalogue import TargetEntry
from minkref.fuzz.run.declared import declarations_of
from minkref.fuzz.run.runner import Run
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.baseline import Baseline, read_baseline
from minkref.output.documents import Stopwatch, as_text
from minkref.output.exits import ExitCode
from minkref.output.output_folder import held_folder
from minkref.output.signals import Ended, ending_in_order
from minkref.verbs.campaign_output import CampaignLine, document_of, print_campaign
from minkref.verbs.campaign_request import CampaignRequest
from minkref.verbs.verify_cases import case_list
from minkref.verbs.verify_limits import MOST_JOBS
from minkref.verbs.verify_request import Cases
from minkref.version import version

PATIENCE = 60.0  # seconds for a lost scheduler to come back
PAUSE = 1.0


class Campaign:
    """A campaign's file, with targets and cases found."""

    def __init__(self, request: CampaignRequest) -> None:
        path = request.file
        self.request = request
        self.file: CampaignFile = read_campaign(path)
        self.folder = request.output or Path(path.stem)
        if self.folder.is_file():
            what = "this is a file, and the ledger needs a folder"
            raise Refusal(what, str(self.folder), "name one by -o", "cannot-write")
        beside = path.parent
        self.baseline = Baseline()
        if self.file.baseline is not None:
            self.baseline = read_baseline(beside / self.file.baseline)
        self.walls = choose(self.file.isolation, tuple(self.file.pass_env), (self.folder,))
        self.limits = limits_of(self.file, self.walls)
        names = [target_from(beside, name) for name in self.file.targets]
        chosen, self.absent = ALL_TARGETS.select(names)
        self.chosen, self.declared = declarations_of(chosen, ALL_TARGETS, self.limits)
        asked = Cases(
            seed=self.file.seed,
            family=self.file.families or None,
            derived=self.file.derived,
            models=False,
        )
        every = case_list(asked, self.declared.values())
        self.plan = Plan(only_settings(every, self.file.settings), self.file.chunk)
        self.head = head_of(self.file, self.chosen, self.plan.whole, self.plan, self.limits)
        self.id = campaign_id(self.head)
        self.versions = {entry.name: entry.version for entry in self.chosen}

    @property
    def goal(self) -> Goal:
        request, budget = self.request, self.file.budget
        cases = request.cases if request.cases is not None else budget.cases
        seconds = request.seconds if request.seconds is not None else budget.time
        if cases is None and seconds is None:
            what = "a campaign without a budget has no end"
            mend = "give --cases or --seconds, or write a table [budget]"
            raise Refusal(what, str(request.file), mend)
        if (cases is not None and cases < 1) or (seconds is not None and not seconds > 0):
            raise Refusal("this budget is too small", "--cases, --seconds", "give more than 0")
        return Goal(cases, seconds, share_of(request.share), self.file.shrink_calls)

    def work(self) -> Work:
        hidden = (os.path.abspath(self.folder),)
        limits = replace(self.limits, isolation=None)
        return Work(self.id, self.head, limits, self.walls.kind, self.walls.passed, hidden)

    def tally(self) -> Tally:
        """Returns the counts so far."""
        run = Run([entry.name for entry in self.chosen])
        tally = Tally(self.folder, self.id, self.versions, self.baseline, run)
        tally.read()
        return tally


def limits_of(file: CampaignFile, walls: Isolation) -> Limits:
    limits = file.limits
    return Limits(
        limits.call_seconds,
        limits.call_memory << 20,
        limits.size_limit,
        limits.call_output << 20,
        limits.call_processes,
        judging_bytes=limits.memory << 20,
        isolation=walls,
    )


def head_of(
    file: CampaignFile, chosen: list[TargetEntry], cases: CaseList, plan: Plan, limits: Limits
) -> dict[str, Any]:
    """Tells campaigns apart, and tells the ledger about this one."""
    head: dict[str, Any] = {
        "format": FORMAT,
        "name": file.name,
        "minkref": version(),
        "seed": file.seed,
        "targets": [entry.name for entry in chosen],
        "versions": {entry.name: entry.version for entry in chosen},
        "families": [family for _, family in plan.families],
        "derived": file.derived,
        "laws": list(cases.laws),
        "doubles": cases.doubles,
        "chunk": file.chunk,
        "limits": _plain(limits.document()),
    }
    return {**head, "id": campaign_id(head)}


def _plain(limits: Mapping[str, Any]) -> dict[str, Any]:
    walls = limits["isolation"]
    return {**limits, "isolation": {**walls, "passed": list(walls["passed"])}}


def share_of(text: str) -> tuple[int, int]:
    """Reads K/N. Refuses anything but 1 <= K <= N."""
    found = re.fullmatch(r"([0-9]{1,6})/([0-9]{1,6})", text)
    if found is None or not 1 <= int(found[1]) <= int(found[2]):
        raise Refusal(f"{text[:40]!r} is no share", "--share", "write 1/2 for the first half")
    return int(found[1]) - 1, int(found[2])


def answer(request: CampaignRequest) -> None:
    watch = Stopwatch()
    dask()
    if request.workers is not None and not 1 <= request.workers <= MOST_JOBS:
        raise Refusal(f"{request.workers} is out of range", "--workers", f"give 1 to {MOST_JOBS}")
    if request.workers is not None and request.scheduler is not None:
        mend = "leave one of them out: the scheduler has its own workers"
        raise Refusal("these exclude each other", "--workers, --scheduler", mend)
    campaign = Campaign(request)
    goal = campaign.goal
    with held_folder(campaign.folder):
        write_json(head_path(campaign.folder, campaign.id), campaign.head)
        tally, notes = campaign.tally(), list[str]()
        tending = Tending(campaign, notes)
        drive = Drive(
            campaign.folder, campaign.plan, campaign.work(), tally, goal, tend=tending.look
        )
        _drive(campaign, drive, notes)
        tending.end()
    run = tally.finished()
    if drive.failed:
        run.failed = "; ".join(f"{name}: {why}" for name, why in drive.failed.items())
    code = run.exit_code(request.strict)
    value = document_of(campaign, drive, watch, code, notes)
    if request.json:
        sys.stdout.write(as_text(value))
    elif not request.quiet:
        print_campaign(drive, value)
    if code == ExitCode.INTERNAL:
        sys.stderr.write(f"minkref: {run.failed}\n")
    if code:
        raise typer.Exit(int(code))


class Tending:
    """Compacts the ledger and writes pages beside the work; a fault there costs no result."""

    def __init__(self, campaign: Campaign, notes: list[str]) -> None:
        self._folder, self._site = campaign.folder, campaign.request.site
        self._notes = notes
        self._compaction = threading.Thread()

    def look(self) -> None:
        """Starts compaction and writes pages."""
        if not self._compaction.is_alive():
            self._compaction = threading.Thread(target=self._compact, daemon=True)
            self._compaction.start()
        self._write(live=True)

    def end(self) -> None:
        """Waits, and writes the last pages."""
        if self._compaction.ident is not None:
            self._compaction.join()
        self._write(live=False)

    def _compact(self) -> None:
        try:
            compact_if_due(self._folder)
        except (Refusal, OSError) as error:
            self._note(f"the ledger was not compacted: {error}")

    def _write(self, live: bool) -> None:
        if self._site is None:
            return
        from minkref.reports.history.page import write_site

        try:
            write_site(self._folder, self._site, live=live)
        except (Refusal, OSError) as error:
            self._note(f"the pages were not written: {error}")

    def _note(self, text: str) -> None:
        if text not in self._notes:
            self._notes.append(text)


def _drive(campaign: Campaign, drive: Drive, notes: list[str]) -> None:
    """Works until the goal is reached, or a signal ends the run, or no scheduler is left."""
    request, table = campaign.request, campaign.file.cluster
    run = drive.tally.run
    with ExitStack() as stack:
        stack.enter_context(ending_in_order())
        line = stack.enter_context(CampaignLine(drive))
        try:
            place: Any = request.scheduler
            if place is None:
                workers = request.workers or table.workers or os.cpu_count() or 1
                place = stack.enter_context(started(table, workers))
            _with_clients(place, drive, line, notes)
        except KeyboardInterrupt:
            run.ended = int(signal.SIGINT)
        except Ended as ended:
            run.ended = ended.number
        finally:
            HELD.close()
    if run.ended is not None:
        name = signal.Signals(run.ended).name
        notes.append(f"ended by {name}: the same command goes on")


def _with_clients(place: Any, drive: Drive, line: CampaignLine, notes: list[str]) -> None:
    """Connects, and again where a scheduler was lost and comes back."""
    from minkref.fuzz.campaign.worker_plugin import Processes

    lost: float | None = None
    while True:
        try:
            with joined(place) as client:
                client.register_plugin(Processes())
                if has_dashboard():
                    line.say(f"dashboard: {client.dashboard_link}")
                lost = None
                try:
                    drive.run(client, line)
                except (KeyboardInterrupt, Ended):
                    with suppress(OSError, TimeoutError, ValueError):
                        client.unregister_worker_plugin(Processes.name)
                    raise
                client.unregister_worker_plugin(Processes.name)
                return
        except (SchedulerLost, Refusal, OSError, TimeoutError) as error:
            if isinstance(error, Refusal) and not (lost and error.where.startswith("--scheduler")):
                raise
            drive.return_all()
            lost = lost or time.monotonic()
            if time.monotonic() - lost > PATIENCE:
                drive.failed["the scheduler"] = f"it is gone: {error}; the same command goes on"
                return
            line.say(f"the scheduler at {place} is gone: waiting")
            time.sleep(PAUSE)
