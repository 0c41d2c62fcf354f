"""Modules of a page as one script: each once, behind what it imports; what is refused."""

from __future__ import annotations

import re
from pathlib import Path, PurePosixPath

import minkref
import pytest
from minkref.page.modules import Script

PACKAGE = Path(minkref.__file__).parent
SETTINGS = ("plane", "disc", "space", "motion", "scene")
A = "export const a = 1;\nexport function twice(x) { return 2 * x; }\n"


def script(modules: dict[str, str], main: str = "here/main.js") -> str:
    return Script(modules.__getitem__).text(main)


def test_a_module_is_called_once_behind_what_it_imports() -> None:
    text = script(
        {
            "here/main.js": 'import { b } from "./b.js";\nimport {\n  a, twice,\n} from "../a.js";',
            "here/b.js": 'import { a } from "../a.js";\nexport class b {}\n',
            "a.js": A,
        }
    )
    assert re.findall(r"^const \$(\w+) = \(", text, re.M) == ["a", "here_b", "here_main"]
    assert "const { a, twice } = $a;" in text
    assert "return { a, twice };" in text
    assert re.search(r"^(import|export)\b", text, re.M) is None


@pytest.mark.parametrize(
    ("main", "reason"),
    [
        ('import { c } from "./a.js";', "exports no c"),
        ('import { a as b } from "./a.js";', "exports no a as b"),
        ('import a from "./a.js";', "cannot stand in a page"),
        ('import "./a.js";', "cannot stand in a page"),
        ("export let changing = 1;", "cannot stand in a page"),
        ("export const [a, b] = [1, 2];", "cannot stand in a page"),
        ("export default 1;", "cannot stand in a page"),
        ("const end = '</script>';", "cannot stand in a page"),
        ('import { a } from "./main.js";', "imports itself"),
    ],
)
def test_what_cannot_be_put_into_a_page_is_refused(main: str, reason: str) -> None:
    with pytest.raises(ValueError, match=re.escape(reason)):
        script({"here/main.js": main, "here/a.js": A})


ROOMS = [
    *((f"{setting}/page/web", "page/web") for setting in SETTINGS),
    ("disc/page/features/web", "page/web", "disc/page/web"),
]


@pytest.mark.parametrize("rooms", ROOMS, ids=lambda rooms: rooms[0])
def test_a_page_has_each_module_that_it_imports_and_no_other(rooms: tuple[str, ...]) -> None:
    taken: set[str] = set()

    def read(path: str) -> str:
        assert path not in taken
        taken.add(path)
        return (PACKAGE / path).read_text(encoding="utf-8")

    Script(read).text(f"{rooms[0]}/main.js")
    own = {f"{rooms[0]}/{path.name}" for path in (PACKAGE / rooms[0]).glob("*.js")}
    assert own <= taken
    assert {str(PurePosixPath(path).parent) for path in taken} <= set(rooms)
