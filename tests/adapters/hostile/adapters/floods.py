"""More than anybody can read, less than anybody can read, and what is not text at all."""

from __future__ import annotations

import json
import os
import sys
import time

from honest import Adapter, Answer, InTurn, Request, say
from processes import linger

MEGABYTE = b"x" * (1 << 20)


class Floods(Adapter):
    """Writes one endless line."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        while True:
            say(MEGABYTE)


class FloodsInHello(Floods):
    """Writes the endless line as its answer to `hello`."""

    instead = "hello"


class FloodsOfEmptyLines(Adapter):
    instead = "at"

    def mischief(self, request: Request) -> None:
        while True:
            say(b"\n" * (1 << 16))


class FloodsOfAnswers(Adapter):
    """Answers without an end, to a request that has had its answer."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        line = json.dumps({"seq": request["seq"], **self.at(request)}).encode() + b"\n"
        while True:
            say(line * 1000)


class FloodsTheLog(Adapter):
    """Standard error without an end, in lines."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        while True:
            os.write(2, MEGABYTE[:-1] + b"\n")


class FloodsTheLogInSilence(Adapter):
    """Standard error without an end and without a line, beside right answers."""

    def at(self, request: Request) -> Answer:
        for _ in range(300):
            os.write(2, MEGABYTE)
        return super().at(request)


class Drips(Adapter):
    """Writes its answer slowly, a letter each tenth of a second."""

    def line(self, request: Request) -> bytes:
        text = super().line(request)
        if request["verb"] == "at":
            for k in range(min(len(text), 500)):
                say(text[k : k + 1])
                time.sleep(0.1)
        return text


class HalfALine(Adapter):
    """Half of an answer, and then nothing."""

    def line(self, request: Request) -> bytes:
        text = super().line(request)
        if request["verb"] == "at":
            say(text[: len(text) // 2])
            self.then()
            linger()
        return text

    def then(self) -> None:
        pass


class HalfALineAndCloses(HalfALine):
    """Half of an answer, and then no standard output, but still there."""

    def then(self) -> None:
        os.close(1)


class ClosesAll(Adapter):
    """Closes its standard streams, and stays."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        os.closerange(0, 64)
        linger()


class ReadsNothing(Adapter):
    """Answers `hello`, and never reads again."""

    def line(self, request: Request) -> bytes:
        if request["verb"] == "hello":
            say(super().line(request) + b"\n")
            linger()
        return super().line(request)


class HugeAnswer(Adapter):
    """A right answer with a further member of 200 MB."""

    def line(self, request: Request) -> bytes:
        text = super().line(request)
        if request["verb"] == "at":
            say(text[:-1] + b', "x": "')
            for _ in range(200):
                say(MEGABYTE)
            return b'"}'
        return text


class Deep(InTurn):
    """Lists in lists, a million deep, open, closed, and beside a right answer."""

    def spoilt(self, text: bytes, request: Request) -> bytes:
        depth = 10**6
        nest = (b"[" * depth, b'{"a":' * depth, text[:-1] + b',"x":' + b"[" * depth)
        ends = (b"]" * depth, b"1" + b"}" * depth, b"]" * depth + b"}")
        kind = self.count % 6
        return nest[kind % 3] + (ends[kind % 3] if kind > 2 else b"")


class NoText(InTurn):
    """NUL, invalid UTF-8, surrogates, byte order marks, and carriage returns."""

    def spoilt(self, text: bytes, request: Request) -> bytes:
        seq = str(request["seq"]).encode()
        errored = b'{"seq": ' + seq + b', "status": "errored", "reason": "'
        lines = [
            b"\0" + text,
            text + b"\0",
            text[:-1] + b', "x": "\xff\xfe"}',
            b"\xff\xfe" + text.decode().encode("utf-16-le"),
            b"\xef\xbb\xbf" + text,
            errored + b'\\ud800\\udc"}',
            errored + b'\\ud800"}',
            errored + b'\\u0000\\u001b[2J"}',
            errored + b"\xed\xa0\x80" + b'"}',
            text.replace(b'"polygons"', b'"polygons": [], "polygons"'),
            b"result",
            b"\xc0\xaf",
        ]
        return lines[self.count % len(lines)]


class Large(Adapter):
    """Writes large texts directly, without lists that would fill the adapter's memory."""

    def instead_of_sum(self, request: Request, members: str) -> bytes:
        if request["verb"] != "at":
            return super().line(request)
        return f'{{"seq": {request["seq"]}, "status": "result", {members}}}'.encode()


class ManyRings(Large):
    """A hundred thousand rings that all overlap."""

    def line(self, request: Request) -> bytes:
        rings = (f'[["{k}","0"],["{k + 50000}","1"],["0","{k + 1}"]]' for k in range(100_000))
        return self.instead_of_sum(request, '"rings":[' + ",".join(rings) + "]")


class ManyVertices(Large):
    """A ring of two hundred thousand vertices that crosses itself everywhere."""

    def line(self, request: Request) -> bytes:
        ring = (f'["{k * 7919 % 104729}","{k * 104729 % 7919}"]' for k in range(200_000))
        return self.instead_of_sum(request, '"polygons":[{"outer":[' + ",".join(ring) + "]}]")


class LongDenominators(Adapter):
    """Vertices with coprime denominators, whose common denominator is very long."""

    def at(self, request: Request) -> Answer:
        ring = [[f"1/{10**900 + 2 * k + 1}", f"{k * k}/{7**1000 + k}"] for k in range(3000)]
        return {"status": "result", "polygons": [{"outer": ring}]}


class Empty(Adapter):
    """Closes its output without a word, and waits for the end of its input."""

    instead = "at"

    def mischief(self, request: Request) -> None:
        os.close(1)
        sys.stdin.buffer.read()
        os._exit(0)
