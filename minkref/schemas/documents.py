"""All documents."""

from __future__ import annotations

from minkref.schemas.bench.document import BenchDocument
from minkref.schemas.campaigns import (
    CampaignCompactDocument,
    CampaignQueryDocument,
    CampaignSiteDocument,
)
from minkref.schemas.cases import GenerateDocument
from minkref.schemas.certificates import CertifyDocument, CheckDocument
from minkref.schemas.disc.closing import DiscClosingDocument, DiscOpeningDocument
from minkref.schemas.disc.convolution import DiscConvolutionDocument
from minkref.schemas.disc.decompose import DecomposeDocument
from minkref.schemas.disc.erode import DiscErodeDocument
from minkref.schemas.disc.events import DiscEventsDocument
from minkref.schemas.disc.features import FeaturesDocument
from minkref.schemas.disc.index import DiscIndexDocument
from minkref.schemas.disc.pair_events import DiscPairEventsDocument
from minkref.schemas.disc.sum import DiscSumDocument
from minkref.schemas.disc.sweep import DiscSweepDocument
from minkref.schemas.disc.values import CurvedRing, ExactPoint, Radius
from minkref.schemas.disc.view import DiscViewDocument, FeatureViewDocument
from minkref.schemas.error import ErrorDocument
from minkref.schemas.lists import FamiliesDocument, ModelsDocument, TargetsDocument
from minkref.schemas.motion.discs import (
    ClearFitBracketDocument,
    ClearFitDocument,
    ClearFitScaleDocument,
    ClearPathDocument,
    ClearTrapDocument,
    ClearTrapScaleDocument,
    DiscFitDocument,
    DiscPathDocument,
    DiscTrapDocument,
)
from minkref.schemas.motion.fit import FitDocument, SpaceFitDocument
from minkref.schemas.motion.hold import HoldDocument, SpaceHoldDocument
from minkref.schemas.motion.path import PathDocument, SpacePathDocument
from minkref.schemas.motion.trap import SpaceTrapDocument, TrapDocument
from minkref.schemas.motion.view import PathViewDocument
from minkref.schemas.plane.convolution import ConvolutionDocument
from minkref.schemas.plane.erode import (
    ClosingDocument,
    ErodeDocument,
    InnerFitDocument,
    NoFitDocument,
    OpeningDocument,
)
from minkref.schemas.plane.events import EventsDocument
from minkref.schemas.plane.index import IndexDocument
from minkref.schemas.plane.point import PointDocument
from minkref.schemas.plane.set_operations import (
    DifferenceDocument,
    IntersectionDocument,
    UnionDocument,
)
from minkref.schemas.plane.sum import SumDocument
from minkref.schemas.plane.sweep import SweepDocument
from minkref.schemas.plane.values import Ring
from minkref.schemas.plane.view import ViewDocument
from minkref.schemas.repair import RepairDocument
from minkref.schemas.report import ReportDocument
from minkref.schemas.scene.file import SceneFileText
from minkref.schemas.scene.scene import SceneDocument
from minkref.schemas.scene.view import SceneViewDocument
from minkref.schemas.space.ball import BallErodeDocument, BallSumDocument
from minkref.schemas.space.convolution import SpaceConvolutionDocument
from minkref.schemas.space.erode import (
    SpaceClosingDocument,
    SpaceErodeDocument,
    SpaceInnerFitDocument,
    SpaceNoFitDocument,
    SpaceOpeningDocument,
)
from minkref.schemas.space.events import SpaceEventsDocument
from minkref.schemas.space.sum import SpaceSumDocument
from minkref.schemas.space.sweep import SpaceSweepDocument
from minkref.schemas.space.values import FlatRing
from minkref.schemas.space.view import SpaceViewDocument
from minkref.schemas.values import Digest, Fraction, Number, Point, SpacePoint
from minkref.schemas.verify.adapter_check import AdapterCheckDocument
from minkref.schemas.verify.campaign import (
    CampaignMergeDocument,
    CampaignRunDocument,
    CampaignStatusDocument,
)
from minkref.schemas.verify.cases import AnyPoint, CaseRing
from minkref.schemas.verify.document import ShrinkDocument, VerifyDocument

DOCUMENTS = {
    "adapter_check": AdapterCheckDocument,
    "bench": BenchDocument,
    "campaign_compact": CampaignCompactDocument,
    "campaign_query": CampaignQueryDocument,
    "campaign_site": CampaignSiteDocument,
    "campaign_merge": CampaignMergeDocument,
    "campaign_run": CampaignRunDocument,
    "campaign_status": CampaignStatusDocument,
    "certify": CertifyDocument,
    "check": CheckDocument,
    "closing": ClosingDocument,
    "closing_in_space": SpaceClosingDocument,
    "closing_with_disc": DiscClosingDocument,
    "convolution": ConvolutionDocument,
    "convolution_in_space": SpaceConvolutionDocument,
    "convolution_with_disc": DiscConvolutionDocument,
    "decompose": DecomposeDocument,
    "difference": DifferenceDocument,
    "erode": ErodeDocument,
    "erode_in_space": SpaceErodeDocument,
    "erode_with_ball": BallErodeDocument,
    "erode_with_disc": DiscErodeDocument,
    "error": ErrorDocument,
    "events": EventsDocument,
    "events_in_space": SpaceEventsDocument,
    "events_with_disc": DiscEventsDocument,
    "events_with_disc_pairs": DiscPairEventsDocument,
    "families": FamiliesDocument,
    "features": FeaturesDocument,
    "fit": FitDocument,
    "fit_at_scale": ClearFitScaleDocument,
    "fit_in_space": SpaceFitDocument,
    "fit_with_bracket": ClearFitBracketDocument,
    "fit_with_clearance": ClearFitDocument,
    "fit_with_disc": DiscFitDocument,
    "generate": GenerateDocument,
    "hold": HoldDocument,
    "hold_in_space": SpaceHoldDocument,
    "index": IndexDocument,
    "index_with_disc": DiscIndexDocument,
    "innerfit": InnerFitDocument,
    "innerfit_in_space": SpaceInnerFitDocument,
    "intersection": IntersectionDocument,
    "models": ModelsDocument,
    "nofit": NoFitDocument,
    "nofit_in_space": SpaceNoFitDocument,
    "opening": OpeningDocument,
    "opening_in_space": SpaceOpeningDocument,
    "opening_with_disc": DiscOpeningDocument,
    "path": PathDocument,
    "path_in_space": SpacePathDocument,
    "path_with_clearance": ClearPathDocument,
    "path_with_disc": DiscPathDocument,
    "point": PointDocument,
    "repair": RepairDocument,
    "report": ReportDocument,
    "scene": SceneDocument,
    "scene_file": SceneFileText,
    "shrink": ShrinkDocument,
    "sum": SumDocument,
    "sum_in_space": SpaceSumDocument,
    "sum_with_ball": BallSumDocument,
    "sum_with_disc": DiscSumDocument,
    "sweep": SweepDocument,
    "sweep_in_space": SpaceSweepDocument,
    "sweep_with_disc": DiscSweepDocument,
    "targets": TargetsDocument,
    "trap": TrapDocument,
    "trap_at_scale": ClearTrapScaleDocument,
    "trap_in_space": SpaceTrapDocument,
    "trap_with_clearance": ClearTrapDocument,
    "trap_with_disc": DiscTrapDocument,
    "union": UnionDocument,
    "verify": VerifyDocument,
    "view": ViewDocument,
    "view_in_space": SpaceViewDocument,
    "view_of_features": FeatureViewDocument,
    "view_of_scene": SceneViewDocument,
    "view_with_disc": DiscViewDocument,
    "view_with_path": PathViewDocument,
}
NAMED = {
    "Number": Number,
    "Fraction": Fraction,
    "Digest": Digest,
    "Radius": Radius,
    "Point": Point,
    "SpacePoint": SpacePoint,
    "AnyPoint": AnyPoint,
    "Ring": Ring,
    "FlatRing": FlatRing,
    "CaseRing": CaseRing,
    "ExactPoint": ExactPoint,
    "CurvedRing": CurvedRing,
}
