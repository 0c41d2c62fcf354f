"""Campaigns: chunks, the client's loop before failures and deaths, one campaign by real workers."""

from __future__ import annotations

import itertools
import json
import os
import random
import shutil
import signal
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from campaign_stubs import Client, Death, names
from minkref.cli import cli
from minkref.errors import Refusal
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.campaign import engine
from minkref.fuzz.campaign.campaign_file import read_campaign
from minkref.fuzz.campaign.chunks import Plan
from minkref.fuzz.campaign.engine import Drive, Goal
from minkref.fuzz.campaign.judging import Work
from minkref.fuzz.campaign.tally import Tally
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.isolation.isolation import choose
from minkref.fuzz.ledgers.counting import rows_of_ledger
from minkref.fuzz.run import pool
from minkref.fuzz.run.case_list import CaseList
from minkref.fuzz.run.runner import Run
from minkref.fuzz.run.worker import Job
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.baseline import Baseline
from minkref.fuzz.verdicts.verdict import Verdict
from minkref.schemas import schema
from thoroughness import draws

SEED = 31
WHOLE = CaseList(SEED, families=("random", "holes", "comb"), models=False)
CAMPAIGN = "0123456789ab"
WORK = Work(CAMPAIGN, {"versions": {"right": "1", "other": "2"}, "minkref": "0"}, Limits(), "none")


class Shows:
    """Lets the client finish tasks between two looks."""

    def __init__(self, client: Client) -> None:
        self.client = client

    def show(self, drive: Drive) -> None:
        self.client.finish_some()


def drive(folder: Path, cases: int, share: tuple[int, int] = (0, 1)) -> Drive:
    versions: dict[str, str | None] = {"right": "1", "other": "2"}
    tally = Tally(folder, CAMPAIGN, versions, Baseline(), Run(["right", "other"]))
    tally.read()
    return Drive(folder, Plan(WHOLE, 10), WORK, tally, Goal(cases, share=share, shrink_calls=5))


def told(folder: Path, tally: Tally) -> Any:
    """Returns all that must not depend on workers and deaths."""
    kinds = {kind.key: kind.count for kind in tally.kinds.values()}
    cells = {key: dict(cell.verdicts) for key, cell in tally.run.matrix.items()}
    return kinds, cells, tally.cases, tally.behaviours, rows_of_ledger(folder).to_pylist()


@pytest.fixture(autouse=True)
def quick_looks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(engine, "TICK", 0.001)


def test_chunks_have_the_cases_of_verify_and_depend_on_their_number_alone() -> None:
    plan = Plan(WHOLE, 10)
    numbers = list(plan.numbers(90))
    assert sum(plan.planned(number) for number in numbers) == 90
    found = [name.text for number in numbers for name in names(plan.chunk(number))]
    asked = CaseList(SEED, 90, families=WHOLE.families, models=False)
    assert sorted(found) == sorted(n.text for n in asked if isinstance(n, CaseName))
    again = Plan(WHOLE, 10)
    for number in reversed(numbers):
        assert names(again.chunk(number)) == names(plan.chunk(number))


def test_a_larger_budget_begins_with_the_chunks_of_a_smaller_one() -> None:
    plan = Plan(CaseList(SEED, families=("random", "lattice"), derived=True, laws=("swap",)), 30)
    few, many = list(plan.numbers(100)), list(plan.numbers(1000))
    assert many[: len(few)] == few
    chunks = [plan.chunk(number) for number in many]
    assert len({chunk.name for chunk in chunks}) == len(chunks)
    texts = [name.text for chunk in chunks for name in names(chunk)]
    assert len(set(texts)) > 0.9 * len(texts)  # a derived case may be drawn twice


def test_any_number_of_workers_in_any_order_finds_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    print(f"seed {SEED}")
    expected = None
    for k in range(draws(3, 30)):
        monkeypatch.setattr(engine, "STATE_SECONDS", 0.0 if k % 2 else 5.0)
        dice = random.Random(f"{SEED} {k}")
        client = Client(dice, (1, 3, 200)[k % 3], fails=0.1 * (k % 2))
        one = drive(tmp_path / str(k), 120)
        while True:
            one.run(client, Shows(client))
            if not one.failed:
                break
            one = drive(tmp_path / str(k), 120)  # a chunk failed too often: run again
        found = told(tmp_path / str(k), one.tally)
        expected = expected or found
        assert found == expected
    assert expected is not None and len(expected[0]) == 3


def test_killed_clients_lose_no_part_and_repeat_only_chunks_in_flight(tmp_path: Path) -> None:
    print(f"seed {SEED}")
    whole, client = drive(tmp_path / "whole", 120), Client(random.Random(SEED), 2)
    whole.run(client, Shows(client))
    for k in range(draws(3, 30)):
        dice, folder = random.Random(f"{SEED} {k}"), tmp_path / str(k)
        judged: list[str] = []
        for budget in itertools.chain((40, 80), itertools.repeat(120)):
            one = drive(folder, budget)
            if dice.random() < 0.5:
                one.close = lambda: None  # type: ignore[method-assign] dies before any state
            client = Client(dice, 2, dies=0.2)
            before = {path.stem for path in (folder / "ledger" / "parts").glob("*")}
            try:
                one.run(client, Shows(client))
            except Death:
                continue
            finally:
                judged += client.judged
                assert not before & {f"{CAMPAIGN}-{name}" for name in client.judged}
            if budget == 120:
                break
        last = drive(folder, 120)
        last.run(client, Shows(client))
        assert told(folder, last.tally) == told(tmp_path / "whole", whole.tally)


def test_shares_are_the_whole(tmp_path: Path) -> None:
    for k in range(2):
        client = Client(random.Random(SEED), 3)
        drive(tmp_path / "halves", 120, (k, 2)).run(client, Shows(client))
    shutil.rmtree(tmp_path / "halves" / "state")
    shutil.rmtree(tmp_path / "halves" / "kinds")
    joined, client = drive(tmp_path / "halves", 120), Client(random.Random(SEED), 3)
    joined.run(client, Shows(client))
    assert not client.judged and joined.tally.kinds
    assert all(kind.tried for kind in joined.tally.kinds.values())
    client = Client(random.Random(SEED), 3)
    one = drive(tmp_path / "whole", 120)
    one.run(client, Shows(client))
    assert told(tmp_path / "halves", joined.tally) == told(tmp_path / "whole", one.tally)
    halves, wanted = (rows_of_ledger(tmp_path / name) for name in ("halves", "whole"))
    assert halves.equals(wanted)


def test_a_worker_killed_from_outside_is_asked_again(monkeypatch: pytest.MonkeyPatch) -> None:
    real, kills = pool._read, 1

    def killed(worker: Any) -> Any:
        nonlocal kills
        if worker.step == "minkref:winding" and kills:
            kills -= 1
            os.kill(worker.process.pid, signal.SIGKILL)
            return pool._died(worker)  # whatever it had sent by then
        return real(worker)

    monkeypatch.setattr(pool, "_read", killed)
    job = Job(0, CaseName("random:1:5", "named"))
    with pool.Pool(["minkref:winding"], ALL_TARGETS, Limits(), 1) as workers:
        (first,) = workers.results([job])
        kills = 2
        (second,) = workers.results([Job(1, job.name)])
    assert [outcome.verdict for outcome in first.outcomes] == [Verdict.PASS]
    assert [outcome.verdict for outcome in second.outcomes] == [Verdict.CRASHED]


def test_shrinking_ends_no_program_of_a_pool_beside_it(faulty_sums: None) -> None:
    limits, name = Limits(isolation=choose("none")), CaseName("random:1:5", "named")
    target = "py:faulty_sums:right"
    with pool.Pool([target], ALL_TARGETS, limits, 1) as kept:
        before = [result.outcomes[0].verdict for result in kept.results([Job(0, name)])]
        with pool.Pool([target], ALL_TARGETS, limits, 1) as other:
            list(other.results([Job(0, name)]))
        after = [result.outcomes[0].verdict for result in kept.results([Job(1, name)])]
    assert before == after == [Verdict.PASS]


@pytest.mark.parametrize(
    ("text", "where"),
    [
        ("targets = []", "targets"),
        ("target = ['geos']", "`target`"),
        ("targets = ['geos']\nseed = 'x'", "seed"),
        ("targets = ['geos']\nsettings = ['line']", "settings"),
        ("targets = ['geos']\n[budget]\ncases = 0", "budget.cases"),
        ("targets = ['geos']\n[cluster]\nworker = 3", "cluster"),
        ("targets", "campaign.toml"),
    ],
)
def test_a_wrong_file_is_refused_with_its_place(tmp_path: Path, text: str, where: str) -> None:
    path = tmp_path / "campaign.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(Refusal) as refused:
        read_campaign(path)
    assert where in f"{refused.value.where} {refused.value.what}"
    assert refused.value.mend


@pytest.fixture
def command(
    tmp_path: Path,
    faulty_sums: None,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> Callable[..., tuple[int, Any]]:
    monkeypatch.chdir(tmp_path)

    def run(*words: str) -> tuple[int, Any]:
        code = cli.run(("campaign", *words, "--json"))
        value = json.loads(capsys.readouterr().out)
        jsonschema.validate(value, schema(f"campaign_{words[0]}"))
        return code, value

    return run


def test_a_campaign_finds_continues_extends_and_merges(
    command: Callable[..., tuple[int, Any]], tmp_path: Path
) -> None:
    (tmp_path / "c.toml").write_text(
        'targets = ["py:faulty_sums:loses_holes", "minkref:winding"]\nfamilies = ["holes"]\n'
        "derived = false\nchunk = 5\nshrink-calls = 5\n[budget]\ncases = 10\n",
        encoding="utf-8",
    )
    code, first = command("run", "c.toml", "--workers", "2")
    assert code == 1 and first["cases_here"] == first["cases"] == 10
    (kind,) = first["kinds"]
    assert kind["first"]["reasons"] == ["hole-lost"] and kind["first"]["witness"]
    assert kind["shrunk"] and not kind["unshrunk"]
    _, again = command("run", "c.toml", "--workers", "1")
    assert again["cases_here"] == 0 and again["kinds"] == first["kinds"]
    command("run", "c.toml", "--workers", "1", "--cases", "20", "--share", "2/2", "-o", "half")
    code, merged = command("merge", "c", "half", "-o", "both")
    assert code == 0 and merged["repeated"] == 1 and not merged["differing"]
    _, both = command("run", "c.toml", "--workers", "1", "--cases", "20", "-o", "both")
    _, more = command("run", "c.toml", "--workers", "1", "--cases", "20")
    assert (both["cases_here"], more["cases_here"]) == (5, 10)
    assert rows_of_ledger(tmp_path / "both").equals(rows_of_ledger(tmp_path / "c"))
    assert both["kinds"] == more["kinds"]
    _, status = command("status", "c")
    assert [row["cases"] for row in status["campaigns"]] == [20]


def test_bad_words_are_refused_before_any_folder_is_made(
    command: Callable[..., tuple[int, Any]], tmp_path: Path
) -> None:
    (tmp_path / "c.toml").write_text('targets = ["minkref:winding"]\n', encoding="utf-8")
    for words in (
        ("run", "c.toml"),  # no budget
        ("run", "absent.toml", "--cases", "5"),
        ("run", "c.toml", "--cases", "0"),
        ("run", "c.toml", "--cases", "5", "--share", "3/2"),
        ("run", "c.toml", "--cases", "5", "--workers", "0"),
        ("run", "c.toml", "--cases", "5", "--workers", "2", "--scheduler", "tcp://127.0.0.1:1"),
        ("status", "."),
    ):
        code, value = command(*words)
        assert code == 2 and value["error"]["mend"], words
    assert [path.name for path in tmp_path.iterdir()] == ["c.toml"]
