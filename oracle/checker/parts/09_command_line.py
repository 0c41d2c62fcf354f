

# The last part: the certificate as a whole, and the command.

Verdict = tuple[int, str, list[str]]  # the code, why, what is claimed
Limits = tuple[float, float, float]  # seconds, tests, and bytes of a file
FILES: list[Reader] = [file_bytes, file_bytes]  # read the certificate, and the case
INPUT: list[Reader] = [lambda _, most: sys.stdin.buffer.read(int(most) + 1), file_bytes]


def check(path: Path, case: Path | None, limits: Limits, read: Sequence[Reader]) -> list[str]:
    """The case, and the claims that a certificate proves, as texts. Raises NotVerified."""
    size, budget = limits[2], Budget(*limits[:2])
    certificate = read_json(path, read[0], size, decimals=False)
    form = certificate.get("certificate") if isinstance(certificate, dict) else None
    require(form in tuple(FORMS), f"this is no {' or '.join(FORMS)}, but {form!r}")
    argument, follow = FORMS[form]
    names = f"certificate title? comment? producer? case {argument} claims"
    _, *told, of = (found := members(certificate, names))[:5]
    require(all(t is None or isinstance(t, str) for t in told), "what carries no truth is no text")
    name, digest = members(of, "path sha256")
    steps = name.split("/") if isinstance(name, str) and "\0" not in name else [""]
    require(steps[-1] not in ("", "."), "the path of the case is none")
    inside = case is not None or {"", ".."}.isdisjoint(steps)
    require(inside, f"the case {name} is in another folder: give --case FILE")
    value = read_json(case := case or path.parent / name, read[1], size, decimals=True)
    require(isinstance(value, dict), "this is no case")
    return [f"case {case}, {digest}", *follow(value, digest, *found[5:], budget)]


def verdict(path: Path, case: Path | None, limits: Limits, read: Sequence[Reader]) -> Verdict:
    """The code, why it is not verified, and the case and what is claimed."""
    sys.set_int_max_str_digits(0)
    try:
        return VERIFIED, "", check(path, case, limits, read)
    except NotVerified as error:
        return error.code, str(error), []
    except (MemoryError, RecursionError):
        return OUT_OF_BUDGET, "there is too little memory", []
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description="Checks certificates of Minkowski sums.")
    parser.add_argument("files", nargs="+", type=Path, metavar="FILE", help="- is standard input")
    parser.add_argument("--case", type=Path, help="the case, instead of the path that is named")
    parser.add_argument("--seconds", type=float, default=600, help="for one certificate (600)")
    parser.add_argument("--tests", type=float, default=1e10, help="elementary tests (10^10)")
    parser.add_argument("--bytes", type=float, default=2**28, help="of a file (2^28)")
    given = parser.parse_args(arguments)
    words = {VERIFIED: "verified", REFUTED: "refuted: ", MALFORMED: "malformed: "}
    limits, codes = (given.seconds, given.tests, given.bytes), set()
    for path in given.files:
        code, why, said = verdict(path, given.case, limits, INPUT if str(path) == "-" else FILES)
        told = f"{path}: {words.get(code, 'out of budget: ')}{why}", *(f"  {line}" for line in said)
        print(*(line.encode("unicode_escape").decode() for line in told), sep="\n", flush=True)
        codes.add(code)
    return next((c for c in (REFUTED, MALFORMED, OUT_OF_BUDGET) if c in codes), VERIFIED)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except OSError:  # nobody takes the verdict
        os._exit(70)
