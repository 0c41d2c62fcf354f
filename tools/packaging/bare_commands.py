"""Runs of all minkref commands for a bare machine, with their expected results."""

from __future__ import annotations

from dataclasses import dataclass

#: Functions to be verified, as somebody writes them who has nothing but the wheel.
FUNCTIONS = """
import json

import minkref


def right(P, Q):
    first, second = (minkref.read_text(json.dumps(operand), "json") for operand in (P, Q))
    return json.loads(minkref.write(minkref.minkowski_sum(first, second).region, "json"))


def nothing(P, Q):
    return {"polygons": []}


for function in (right, nothing):
    function.minkref = {
        "name": function.__name__, "version": "1", "arithmetic": "rational", "numbers": "text",
        "capabilities": ["plane", "non-convex", "holes", "components"],
    }
"""
#: A path as a word.
WAY = '{"type":"LineString","coordinates":[[-60,55],[60,55]]}'
#: A scene as a word.
SCENE = (
    '{"schema":"scene-v1","robot":"g2","shapes":{"letter":"g1"},"copies":['
    '{"shape":"letter","scale":"1/2","place":[0,0]},{"shape":"letter","scale":2,"place":[99,0]}]}'
)
FEW = ("--pairs", "5", "--no-models", "--family", "random")


@dataclass(frozen=True)
class Step:
    """A run: the words after `minkref`, the exit code, words that the command says, and files that
    it leaves. --quick omits slow steps. Without the package's `extra` the command is refused; if
    the extra is `optional`, the command does less."""

    words: tuple[str, ...]
    says: str = ""
    code: int = 0
    files: tuple[str, ...] = ()
    slow: bool = False
    extra: str = ""
    optional: bool = False


def step(line: str, says: str = "", **more: object) -> Step:
    return Step(tuple(line.split()), says, **more)  # type: ignore[arg-type]


STEPS = (
    step("--version", "minkref "),
    step("models", "disc1"),
    step("families", "random"),
    step("targets", "minkref:paper"),
    step("sum g1 g2 --json", '"digest"'),
    step("sum g1 g2 --scale 7/5 --plot -o sum.svg", "\u286a", files=("sum.svg",)),
    step("sum g1 disc:7/5 -o offset.dxf", extra="dxf", files=("offset.dxf",)),
    step("sum g1 g2 --arithmetic mpfr:64", "mpfr"),
    step("sum gs3 gs4 --scale 2,1/3,5 -o sum.off", files=("sum.off",)),
    step("sum g1 g2 --route paper-update --arithmetic mpfr:64", "another structure"),
    step("point g1 g2 --at 0,0"),
    step("convolution g1 g2 -o convolution.svg", files=("convolution.svg",)),
    step("repair g1", "no changes"),
    step("union g1 g2 -o both.wkt", files=("both.wkt",)),
    step("intersection g1 g2 --plot", "\u286a"),
    step("difference g1 g2 --json", '"digest"'),
    step("decompose g1 -o pieces.svg", "pieces", files=("pieces.svg",)),
    step(f"scene {SCENE} --passages -o scene.wkt", "tight passages", files=("scene.wkt",)),
    step("index g1 g2 --from 1/2 --to 2 -o pair.index", files=("pair.index",)),
    step("sum g1 g2 --index pair.index --scale 7/5"),
    step("sweep g1 g2 --from 1/2 --to 2 --steps 5 -o sums", files=("sums/index.json",)),
    step("events g1 g2 --kind topology"),
    step("events g1 g2 -o events.parquet", "parquet", extra="parquet", files=("events.parquet",)),
    step("view g1 g2", "view.html", files=("view.html",)),
    step("view g1 g2 --route paper-update --steps 3 -o paper.html", files=("paper.html",)),
    step("view gs3 gs4 -o space.html", extra="view", files=("space.html",)),
    step("index g1 disc -o disc.json", files=("disc.json",)),
    step("sum g1 disc:1/2 --index disc.json"),
    step("features g1 --alpha 2 -o features.svg", files=("features.svg",)),
    step("features g1 --alpha 2 -o bridges.dxf", extra="dxf", files=("bridges.dxf",)),
    step("erode g1 g2 --scale 20 -o eroded.svg", "remnants", files=("eroded.svg",)),
    step("index g1 g2 --erode -o eroded.index", files=("eroded.index",)),
    step("erode g1 g2 --scale 20 --index eroded.index --json", '"digest"'),
    step("events g1 g2 --erode --kind topology"),
    step("erode g1 disc:1/2 -o inset.svg", "components", files=("inset.svg",)),
    step("events g1 disc --erode", "inradius"),
    step("erode gs3 gs4 --scale 9 -o places.off", "volume", files=("places.off",)),
    step("opening g1 g2 --scale 20 --plot", "\u286a"),
    step("closing g1 g2 -o closed.wkt", files=("closed.wkt",)),
    step("opening g1 disc:1/2 -o opened.svg", "arcs", files=("opened.svg",)),
    step("closing g1 disc:1/2 -o closed.dxf", extra="dxf", files=("closed.dxf",)),
    step("nofit g1 g2 --json", '"exact_fits"'),
    step("nofit gs3 gs4", "exact fits"),
    step("innerfit g1 g2 --scale 20 --json", '"exact_fits"'),
    step("fit g2 g1 --at 0,0", "93/1360"),
    step("fit disc g1 --anywhere", "8.34207465"),
    step(f"path disc g2 {WAY} -o track.svg", "valid radii", files=("track.svg",)),
    step("trap g2 g1 --at 0,0 --from 1 --to 2", "by translation"),
    step(f"hold disc1 g2 {WAY}", "way valid"),
    step(f"view disc1 g2 --path {WAY} -o way.html", "valid scales", files=("way.html",)),
    step(f"path disc1 g2 {WAY} -o way.svg", "valid scales", files=("way.svg",)),
    step("certify g1 g2 -o sum.cert.json", files=("sum.cert.json",)),
    step("check sum.cert.json"),
    step("sum g1 disc:7/5 --certify grown.cert.json", files=("grown.cert.json",)),
    step(f"path disc1 g2 {WAY} --certify way.cert.json", "valid", files=("way.cert.json",)),
    step("generate fits-hole --count 2 -o cases"),
    step("check cases"),
    step("adapter header", "minkref_adapter.h"),
    step("adapter new mylib --language python", files=("mylib_adapter.py",)),
    step("adapter check ./mylib_adapter.py", "pass"),
    step("verify ./mylib_adapter.py --report report --quiet", files=("report/index.html",)),
    step("verify py:functions:right", "pass"),
    step("verify py:functions:nothing", "wrong", code=1),
    step(
        "shrink random:1:0 --target py:functions:nothing -o found.json",
        code=1,
        files=("found.json",),
    ),
    step("campaign status .", "no campaign", code=2),
    step("verify minkref --pairs 2 --no-models", extra="judges", optional=True, slow=True),
    step("report degeneracies -o pages", slow=True),
    step("report audit --quick -o audit", extra="reports", slow=True),
    step("bench --quick --only table2 --json", '"table2"', slow=True),
)


def words_of(one: Step) -> tuple[str, ...]:
    """The step's words; runs of verify are cut to a few cases from one family."""
    short = one.words[0] == "verify" and "--pairs" not in one.words
    return (*one.words, *FEW) if short else one.words
