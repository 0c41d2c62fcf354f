"""Documents of `certify` and `check`, and certificates that other commands write."""

from __future__ import annotations

from typing import Annotated, Literal, NotRequired, TypedDict

from minkref.schemas.grammar import ruled
from minkref.schemas.values import Count, Head, PositiveCount
from msgspec import Meta

CheckVerdict = Literal["verified", "refuted", "malformed", "out of budget", "declined"]


@ruled(additionalProperties=True)
class Claim(TypedDict):
    claim: str


class CertifyDocument(Head):
    """The document of `minkref certify --json`."""

    command: Literal["certify"]
    output: Annotated[str, Meta(description="The certificate.")]
    case: Annotated[str, Meta(description="The file of its case.")]
    bytes: Annotated[Count, Meta(description="Of the certificate, not compressed.")]
    verified: Annotated[
        bool | None,
        Meta(
            description="Whether the checker verified it before it was written; false where its "
            "budget did not suffice, null with --no-check."
        ),
    ]
    theorem: NotRequired[Annotated[str, Meta(description="With --theorem: the file of Coq.")]]
    claims: Annotated[
        list[Claim], Meta(description="As in the certificate (docs/certificates.md).")
    ]


class Certificate(TypedDict):
    output: str
    case: str
    bytes: Count
    claims: PositiveCount
    verified: bool


CertificateMade = Annotated[
    Certificate | None,
    Meta(
        description="With --certify: the proof that was written, its case, its size not "
        "compressed, the number of its claims, and whether the checker verified it (false where "
        "its budget did not suffice); null without."
    ),
]


class CheckedCase(TypedDict):
    path: Annotated[str, Meta(description="The file that P, Q and so on were read from.")]
    sha256: Annotated[str, Meta(description="Its digest, as in the certificate.")]


class CheckedFile(TypedDict):
    file: str
    verdict: CheckVerdict
    message: Annotated[str, Meta(description="Why it is not verified, or was passed over.")]
    case: Annotated[CheckedCase | None, Meta(description="What is verified is about this case.")]
    claims: Annotated[list[str], Meta(description="What is proven.")]
    checked: NotRequired[
        Annotated[
            Literal["verified"],
            Meta(
                description="With --proved: the verdict of check.py, which proves `claims`; "
                "`verdict` is that of the checker that is proved right."
            ),
        ]
    ]
    proved: NotRequired[
        Annotated[
            list[str],
            Meta(
                description="With --proved, of what is verified: what the checker that is proved "
                "right has found (docs/proved.md)."
            ),
        ]
    ]
    not_proved: NotRequired[
        Annotated[
            list[str], Meta(description="With --proved: what rests on the other checker alone.")
        ]
    ]


class CheckDocument(Head):
    """The document of `minkref check --json`."""

    command: Literal["check"]
    files: list[CheckedFile]
